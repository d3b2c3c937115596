#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include <pleura/tests/x3d/commands/run_program.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Pressures and flows beside the thorax: what moves depends on what was before.
TEST(Render, AStillIsTheFrameOfTheFilmAtItsTime) {
  const TemporaryFolder folder;
  const std::string scene = std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes/pneumothorax.x3d";
  const std::string still = folder.path() / "still.png", film = folder.path() / "film";
  ASSERT_EQ(runProgram({"render", scene, "--at", "0.8", "--size", "320x240", "-o", still}).status, kDone);
  ASSERT_EQ(runProgram({"render", scene, "--for", "0.8", "--size", "320x240", "-o", film}).status, kDone);
  const std::string picture = bytesOf(still);
  EXPECT_FALSE(picture.empty());
  EXPECT_EQ(picture, bytesOf(folder.path() / "film" / "00024.png"));
}

}  // namespace
}  // namespace pleura
