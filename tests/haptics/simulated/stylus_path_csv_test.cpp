#include <algorithm>
#include <filesystem>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/haptics/simulated/stylus_path_csv.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string csvFault(std::string_view text) {
  try {
    parseStylusPath(text, "path.csv");
  } catch (const StylusPathError& error) {
    return error.what();
  }
  return "none";
}

TEST(StylusPathCsv, RowsWithoutAHeader) {
  const auto path = parseStylusPath("0,0,0,0\n2,0.1,-0.2,3e-1\n", "path.csv");
  EXPECT_TRUE(path.position(1).isApprox(Vector3d(0.05, -0.1, 0.15)));
  EXPECT_EQ(parseStylusPath("0,1,2,3,5", "").buttons(0), 5u);
  EXPECT_NEAR(parseStylusPath("0,1,2,3,0,0,1,0", "").orientation(0).z(), 1, 1e-15);
  EXPECT_EQ(parseStylusPath("0,1,2,3,0,0,1,0,7", "").buttons(0), 7u);
}

TEST(StylusPathCsv, AHeaderGivesTheOrder) {
  const auto path = parseStylusPath(
      "Z,buttons,y,x,qw,qz,qy,qx,TIME\n0.3,4,0.2,0.1,0,0,2,0,0\n0.3,6,0.2,0.1,1,0,0,0,1\n", "path.csv");
  EXPECT_EQ(path.position(0), Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(path.buttons(0), 4u);
  EXPECT_TRUE(path.orientation(0).isApprox(Eigen::Quaterniond(0, 0, 1, 0)));
  EXPECT_EQ(path.waypoints().size(), 2u);
}

TEST(StylusPathCsv, BlanksCommentsLineEndsAndByteOrderMarksAreBorne) {
  const auto path =
      parseStylusPath("\xEF\xBB\xBF# the hand\r\n\r\n time , x,y ,z\r\n0 ,\t1, 2,3 \r\n  \n1,1,2,3", "");
  EXPECT_EQ(path.waypoints().size(), 2u);
  EXPECT_EQ(path.position(0), Vector3d(1, 2, 3));
}

TEST(StylusPathCsv, FaultsSayWhereAndWhatWasExpected) {
  EXPECT_EQ(csvFault("time,x,y,z\n0,0,zero,0\n"), "path.csv:2:5: y: expected a number, found \"zero\"");
  EXPECT_EQ(csvFault("0,0,0,nan"), "path.csv:1:1: expected a position in metres, within 10 m, found nan");
  EXPECT_EQ(csvFault("0,0,0,1e999"), "path.csv:1:7: z: expected a number, found \"1e999\"");
  EXPECT_EQ(csvFault("1,0,0,0\n\n0,0,0,0"),
            "path.csv:3:1: expected a time after 1 s, found 0: time goes forwards by a microsecond at least");
  EXPECT_EQ(csvFault("0,0,0,0\n1,0,0"), "path.csv:2:1: expected 4 columns, found 3");
  EXPECT_EQ(csvFault("0,0,0,0\n1,0,0,0,0"), "path.csv:2:1: expected 4 columns, found 5");
  EXPECT_EQ(csvFault("0;0;0;0\n1;0;0;0").substr(0, 80),
            std::string("path.csv:1:1: expected a column of time, x, y, z, qx, qy, qz, qw, buttons, found")
                .substr(0, 80));
  EXPECT_THAT(csvFault("0,0,0"),
              HasSubstr("path.csv:1:1: expected 4, 5, 8 or 9 columns separated by commas"));
  EXPECT_THAT(csvFault("0,0,0,0,0,0,0,0"), HasSubstr("quaternion of length 0"));
  EXPECT_EQ(csvFault("0,0,0,0,-1"), "path.csv:1:9: buttons: expected a whole number, found \"-1\"");
  EXPECT_EQ(csvFault("0,0,0,"), "path.csv:1:7: z: expected a number, found \"\"");
}

TEST(StylusPathCsv, NoRowsIsAFault) {
  for (const char* text : {"", "\n\n", "# nothing", "time,x,y,z\n"})
    EXPECT_THAT(csvFault(text), HasSubstr("expected rows of time, x, y, z, found none")) << text;
}

TEST(StylusPathCsv, FaultsOfAHeader) {
  EXPECT_THAT(csvFault("tmie,x,y,z,timee\n0,0,0,0,0"), HasSubstr("path.csv:1:12: expected a column of"));
  EXPECT_THAT(csvFault("timee,x,y,z\n0,0,0,0"), HasSubstr("found \"timee\"; did you mean time?"));
  EXPECT_THAT(csvFault("time,x,y\n0,0,0"), HasSubstr("path.csv:1:1: expected a column z, found none"));
  EXPECT_THAT(csvFault("time,x,y,z,qx\n0,0,0,0,0"), HasSubstr("expected a column qw, found none"));
  EXPECT_THAT(csvFault("time,x,y,z,X\n0,0,0,0,0"), HasSubstr("path.csv:1:12: expected each column once"));
}

TEST(StylusPathCsv, EveryFaultIsToldUpToTwenty) {
  const std::string three = csvFault("0,a,0,0\n1,0,0,0\n2,0,b,c\n");
  EXPECT_EQ(std::count(three.begin(), three.end(), '\n'), 2);
  EXPECT_THAT(three, HasSubstr("path.csv:1:3: x"));
  EXPECT_THAT(three, HasSubstr("path.csv:3:5: y"));
  EXPECT_THAT(three, HasSubstr("path.csv:3:7: z"));

  std::string text = "0,0,0,0\n";
  for (int row = 0; row < 100'000; ++row) text += "x,y,z,0\n";
  const std::string many = csvFault(text);
  EXPECT_EQ(std::count(many.begin(), many.end(), '\n'), 20);
  EXPECT_THAT(many, HasSubstr("\npath.csv: and 299980 more"));
}

TEST(StylusPathCsv, RubbishIsRefused) {
  EXPECT_THAT(csvFault(std::string_view("0,0,0,0\n\0\0\0", 11)),
              HasSubstr("expected text, found a binary byte"));
  EXPECT_THAT(csvFault(std::string(1'000'000, ',')), HasSubstr("found \"\""));
  EXPECT_THAT(csvFault(std::string(1'000'000, 'x')), HasSubstr("xxx...\""));
  std::mt19937 random(1);
  for (int run = 0; run < 500; ++run) {
    std::string text;
    for (int i = 0; i < 200; ++i)
      text += run % 2 == 0 ? static_cast<char>(random() % 256) : "0123456789.,-e\n#xq "[random() % 20];
    EXPECT_NE(csvFault(text), "none") << text;
  }
}

TEST(StylusPathCsv, AMillionRowsAreRead) {
  std::string text;
  for (int row = 0; row < 1'000'000; ++row) text += std::to_string(row) + ",0,0,0\n";
  EXPECT_EQ(parseStylusPath(text, "").waypoints().size(), 1'000'000u);
  EXPECT_THAT(csvFault(text + "1000001,0,0,0\n1000002,0,0,0\n"),
              HasSubstr("path.csv:1000001:1: expected at most 1000000 rows, found more"));
}

TEST(StylusPathCsv, Files) {
  const TemporaryFolder folder;
  const auto file = folder.write("path.csv", "0,0.01,0,0\n");
  EXPECT_EQ(readStylusPath(file).position(0), Vector3d(0.01, 0, 0));
  std::filesystem::resize_file(file, 1'000'000'000'000);  // a hole: it takes no room
  EXPECT_THROW(readStylusPath(file), StylusPathError);
  EXPECT_THROW(readStylusPath(folder.path() / "missing.csv"), StylusPathError);
  EXPECT_THROW(readStylusPath(folder.path()), StylusPathError);
  EXPECT_THROW(readStylusPath("/dev/zero"), StylusPathError);
}

}  // namespace
}  // namespace pleura::haptics
