#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include <pleura/nodes/core/plugin.h>
#include <pleura/nodes/standard/register.h>
#include <pleura/x3d/browser/anatomy/thorax_files.h>

namespace pleura {
namespace {

const std::filesystem::path kEmbedded = std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes/anatomy";

NodeRegistry thoraxRegistry() {
  NodeRegistry registry;
  registerStandardNodes(registry);
  PluginLoader().load("thorax", registry);
  return registry;
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(ThoraxFiles, AreTheEmbeddedAnatomyByteForByte) {
  const auto files =
      thoraxFiles(generateAnatomy(), thoraxRegistry(),
                  "measured on BodyParts3D, (c) The Database Center for Life Science, CC BY 4.0");
  ASSERT_EQ(files.size(), 27u) << "24 ribs, sternum, spine, thorax";
  for (const auto& file : files) {
    ASSERT_TRUE(std::filesystem::exists(kEmbedded / file.name)) << file.name;
    EXPECT_TRUE(contents(kEmbedded / file.name) == file.text)
        << file.name << " differs: ./pleura anatomy -o scenes/anatomy";
  }
}

TEST(ThoraxFiles, LeaveNothingElseAmongTheEmbedded) {
  int count = 0;
  for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator(kEmbedded)) ++count;
  EXPECT_EQ(count, 27);
}

}  // namespace
}  // namespace pleura
