#include <pleura/tests/x3d/anatomy_files/embedded_files.h>
#include <pleura/x3d/browser/anatomy/chain_files.h>

namespace pleura {
namespace {

TEST(ChainFiles, AreTheOrganFilesByteForByte) {
  const auto files = chainFiles(generateAnatomy(), registryWith("chain"), kMeasuredOn);
  ASSERT_EQ(files.size(), 27u) << "22 ribs, sternum, spine, diaphragm, two lungs";
  expectEmbedded(files, sceneFolder("chain"), "./pleura anatomy -o scenes/chain --style chain");
}

TEST(ChainFiles, StandBesideTheSceneAlone) { EXPECT_EQ(filesIn(sceneFolder("chain")), 28); }

TEST(ChainFiles, AreSmall) {
  std::size_t bytes = 0;
  for (const auto& file : chainFiles(generateAnatomy(), registryWith("chain"), kMeasuredOn))
    bytes += file.text.size();
  EXPECT_LT(bytes, 400'000u);
}

}  // namespace
}  // namespace pleura
