#include <pleura/tests/x3d/anatomy_files/embedded_files.h>
#include <pleura/x3d/browser/anatomy/thorax_files.h>

namespace pleura {
namespace {

TEST(ThoraxFiles, AreTheEmbeddedAnatomyByteForByte) {
  const auto files = thoraxFiles(generateAnatomy(), registryWith("thorax"), kMeasuredOn);
  ASSERT_EQ(files.size(), 27u) << "24 ribs, sternum, spine, thorax";
  expectEmbedded(files, sceneFolder("anatomy"), "./pleura anatomy -o scenes/anatomy");
}

TEST(ThoraxFiles, LeaveNothingElseAmongTheEmbedded) { EXPECT_EQ(filesIn(sceneFolder("anatomy")), 27); }

}  // namespace
}  // namespace pleura
