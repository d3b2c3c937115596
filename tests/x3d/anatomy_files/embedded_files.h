#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/nodes/built_in_nodes.h>
#include <pleura/nodes/core/plugin.h>
#include <pleura/x3d/browser/anatomy/scene_file.h>

namespace pleura {

inline constexpr const char* kMeasuredOn =
    "measured on BodyParts3D, (c) The Database Center for Life Science, CC BY 4.0";

inline NodeRegistry registryWith(const std::string& library) {
  NodeRegistry registry;
  registerBuiltInNodes(registry);
  PluginLoader().load(library, registry);
  return registry;
}

inline std::filesystem::path sceneFolder(const std::string& name) {
  return std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes" / name;
}

/// Each file is in the folder byte for byte; `command` would write it anew.
inline void expectEmbedded(const std::vector<SceneFile>& files, const std::filesystem::path& folder,
                           const std::string& command) {
  for (const auto& file : files) {
    ASSERT_TRUE(std::filesystem::exists(folder / file.name)) << file.name;
    std::ostringstream embedded;
    embedded << std::ifstream(folder / file.name, std::ios::binary).rdbuf();
    EXPECT_TRUE(embedded.str() == file.text) << file.name << " differs: " << command;
  }
}

inline int filesIn(const std::filesystem::path& folder) {
  int count = 0;
  for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator(folder)) ++count;
  return count;
}

}  // namespace pleura
