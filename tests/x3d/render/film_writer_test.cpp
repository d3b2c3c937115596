#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <pleura/x3d/browser/render/film_writer.h>

namespace pleura::render {
namespace {

bool haveProgram(const char* name) {
  return std::system((std::string("command -v ") + name + " >/dev/null").c_str()) == 0;
}

std::string outputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text(400, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), pipe.get()));
  return text;
}

/// PATH for as long as it lives.
class Path {
 public:
  explicit Path(const char* path) : before_(std::getenv("PATH")) { setenv("PATH", path, 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

class FilmWriterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!haveProgram("ffmpeg")) GTEST_SKIP() << "no ffmpeg here";
  }
  void TearDown() override {
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child process is left";
    EXPECT_EQ(errno, ECHILD);
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
    std::filesystem::remove(path);
  }
  std::string path = ::testing::TempDir() + "pleura_film_test.mp4";
};

TEST_F(FilmWriterTest, WritesEveryFrameAsH264WithEvenSides) {
  FilmWriter film(path, 65, 48, 25);
  for (int i = 0; i < 10; ++i) film.write(makeImage(65, 48, static_cast<std::uint8_t>(25 * i), 0, 99));
  EXPECT_FALSE(std::filesystem::exists(path));  // not before it is whole
  film.close();
  const std::string said = outputOf(
      "ffprobe -v error -count_frames -show_entries "
      "stream=codec_name,pix_fmt,width,height,nb_read_frames,r_frame_rate "
      "-of default=nw=1 " +
      path);
  for (const char* word :
       {"codec_name=h264", "width=66", "height=48", "pix_fmt=yuv420p", "nb_read_frames=10", "25/1"})
    EXPECT_NE(said.find(word), std::string::npos) << word << " not in " << said;
}

TEST_F(FilmWriterTest, AFilmThatIsNotClosedLeavesNothing) {
  {
    FilmWriter film(path, 64, 48, 25);
    film.write(makeImage(64, 48));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(FilmWriterTest, AnFfmpegThatFailsIsReportedInItsWords) {
  FilmWriter film("/nowhere/film.mp4", 320, 240, 25);
  try {
    for (int i = 0; i < 100; ++i) film.write(makeImage(320, 240));
    film.close();
    ADD_FAILURE() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/film.mp4"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
}

TEST_F(FilmWriterTest, AMissingFfmpegIsReported) {
  const Path empty("/nowhere");
  try {
    FilmWriter film(path, 64, 48, 25);
    ADD_FAILURE() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("ffmpeg"), std::string::npos) << error.what();
  }
}

TEST_F(FilmWriterTest, BadValuesAreRefused) {
  EXPECT_THROW(FilmWriter(path, 64, 48, 0), std::invalid_argument);
  EXPECT_THROW(FilmWriter(path, 0, 48, 25), std::invalid_argument);
  FilmWriter film(path, 64, 48, 25);
  EXPECT_THROW(film.write(makeImage(63, 48)), std::invalid_argument);
}

}  // namespace
}  // namespace pleura::render
