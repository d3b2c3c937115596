#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/nodes/chain/chain_scene.h>

namespace pleura {
namespace {

using testing::HasSubstr;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// The scene as the thesis would have written it, beside our organ files: attributes that have other names
/// now, urls without quotes, and the diaphragm's clock under the name of the scene's own.
std::unique_ptr<Scene> asInTheThesis(const TemporaryFolder& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(chainFolder()))
    std::filesystem::copy(entry.path(), folder.path());
  std::ostringstream text;
  text << std::ifstream(chainFolder() / "thorax.x3d").rdbuf();
  std::string thesis = replaced(text.str(), "importedDEF", "exportedDEF");
  thesis = replaced(replaced(thesis, "url='\"", "url='./"), ".x3d\"'", ".x3d'");
  return loaded(folder.write("thesis.x3d", replaced(thesis, "AS='timeDiaph'", "AS='TS'")));
}

TEST(ThesisScene, RunsWithWarningsOnly) {
  const TemporaryFolder folder;
  const auto scene = asInTheThesis(folder);
  EXPECT_EQ(scene->diagnostics().errors(), 0u) << toldBy(*scene);
  EXPECT_EQ(scene->diagnostics().warnings(), 3u) << toldBy(*scene);
  EXPECT_THAT(toldBy(*scene), HasSubstr("IMPORT: exportedDEF is read as importedDEF"));
  EXPECT_THAT(toldBy(*scene), HasSubstr("L1.url: read as one string"));
  EXPECT_THAT(toldBy(*scene), HasSubstr("IMPORT: TS is the name of another node here"));
}

TEST(ThesisScene, BreathesAndPausesAsOurs) {
  const TemporaryFolder folder;
  const auto thesis = asInTheThesis(folder);
  const auto ours = chainThorax();
  const auto dome = [](Scene& scene) {
    return scene.field("deformableDiaph.deformedCoord").getValueAsString();
  };
  for (Scene* scene : {thesis.get(), ours.get()}) {
    scene->tick(0.5);
    pressActionKey(*scene, 1);
    scene->tick(0.75);
  }
  const std::string paused = dome(*thesis);
  EXPECT_TRUE(paused == dome(*ours));
  thesis->tick(1.25);
  EXPECT_TRUE(paused == dome(*thesis)) << "the diaphragm's own clock pauses, though the scene can't name it";
}

}  // namespace
}  // namespace pleura
