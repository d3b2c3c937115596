#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/haptics/simulated/stylus_path.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;

Eigen::Quaterniond turn(double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitX()));
}

std::string faultOf(std::vector<StylusWaypoint> waypoints) {
  try {
    StylusPath path(std::move(waypoints));
  } catch (const DeviceError& error) {
    return error.what();
  }
  return {};
}

TEST(StylusPath, ByDefaultRestsAtTheOrigin) {
  EXPECT_EQ(StylusPath().position(5), Vector3d::Zero());
  EXPECT_EQ(StylusPath().buttons(-5), 0u);
}

TEST(StylusPath, GoesStraightAndRestsBeforeAndAfter) {
  const StylusPath path({{.time = 1, .position = {1, 0, 0}},
                         {.time = 2, .position = {1, 2, 0}},
                         {.time = 4, .position = {1, 2, 4}}});
  EXPECT_EQ(path.position(-100), Vector3d(1, 0, 0));
  EXPECT_EQ(path.position(1), Vector3d(1, 0, 0));
  EXPECT_TRUE(path.position(1.25).isApprox(Vector3d(1, 0.5, 0)));
  EXPECT_EQ(path.position(2), Vector3d(1, 2, 0));
  EXPECT_TRUE(path.position(3.5).isApprox(Vector3d(1, 2, 3)));
  EXPECT_EQ(path.position(4), Vector3d(1, 2, 4));
  EXPECT_EQ(path.position(1e9), Vector3d(1, 2, 4));
}

TEST(StylusPath, TurnsEvenlyAndTheShortWay) {
  Eigen::Quaterniond other = turn(1);
  other.coeffs() *= -3;  // the same orientation, of another sign and length
  const StylusPath path({{.time = 0, .orientation = turn(0)}, {.time = 1, .orientation = other}});
  for (const double s : {0.0, 0.25, 0.5, 1.0})
    EXPECT_NEAR(path.orientation(s).angularDistance(turn(s)), 0, 1e-7) << s;
  EXPECT_NEAR(path.orientation(1).norm(), 1, 1e-15);
}

TEST(StylusPath, ButtonsChangeAtWaypoints) {
  const StylusPath path({{.time = 0, .buttons = 1}, {.time = 1, .buttons = 2}});
  EXPECT_EQ(path.buttons(-1), 1u);
  EXPECT_EQ(path.buttons(0.999), 1u);
  EXPECT_EQ(path.buttons(1), 2u);
}

TEST(StylusPath, FaultsNameTheWaypointAndWhatWasExpected) {
  using ::testing::HasSubstr;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(faultOf({}), HasSubstr("found none"));
  EXPECT_EQ(
      faultOf({{.time = 1}, {.time = 0.5}}),
      "waypoint 2 of a stylus: expected a time after 1 s, found 0.5: time goes forwards by a microsecond "
      "at least");
  EXPECT_THAT(faultOf({{.time = 1}, {.time = 1}}), HasSubstr("waypoint 2"));
  EXPECT_THAT(faultOf({{.time = kNan}}), HasSubstr("expected a time within 1e+09 s, found nan"));
  EXPECT_THAT(faultOf({{.time = -1e300}}), HasSubstr("expected a time"));
  EXPECT_THAT(faultOf({{.position = {0, kNan, 0}}}), HasSubstr("in metres, within 10 m, found nan"));
  EXPECT_THAT(faultOf({{.position = {0, 0, -35}}}), HasSubstr("in metres, within 10 m, found -35"));
  EXPECT_THAT(faultOf({{.orientation = {0, 0, 0, 0}}}), HasSubstr("length 0"));
  EXPECT_THAT(faultOf({{.orientation = {1, 0, kNan, 0}}}), HasSubstr("a quaternion, found nan"));
}

}  // namespace
}  // namespace pleura::haptics
