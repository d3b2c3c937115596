#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <pleura/nodes/core/node_registry.h>

namespace pleura {

/// Raised whenever the layout or the meaning of a class that plugins see changes; a plugin built for another
/// number is refused.
inline constexpr int kPluginAbi = 1;

/// Why a library could not be loaded; the registry is as it was.
struct PluginError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Loads shared libraries of nodes. A library offers two C symbols, see PLEURA_PLUGIN. It stays loaded as
/// long as the process: its nodes may outlive any scene.
class PluginLoader {
 public:
  /// Where libraries are looked for: `PLEURA_PLUGIN_PATH` (colon-separated), then beside Pleura's own
  /// libraries. Never in a scene's folder.
  static std::vector<std::filesystem::path> defaultSearchPath();

  explicit PluginLoader(std::vector<std::filesystem::path> searchPath = defaultSearchPath())
      : searchPath_(std::move(searchPath)) {}

  /// Registers the nodes of the library that a scene names: "thorax", but also "thorax.dll", "libthorax.so"
  /// or either in quotes. A library loaded into this registry before is left alone. Throws PluginError.
  void load(std::string_view library, NodeRegistry& registry);

  /// The stem of a library's name; empty when it is no plain name.
  static std::string stem(std::string_view library);

 private:
  std::vector<std::filesystem::path> searchPath_;
  std::vector<std::string> loaded_;
};

}  // namespace pleura

/// Defines the two symbols of a plugin; `registerNodes` is a function that takes a NodeRegistry&.
#define PLEURA_PLUGIN(registerNodes)                                                       \
  extern "C" {                                                                             \
  int pleura_plugin_abi() { return pleura::kPluginAbi; }                                   \
  void pleura_register_nodes(pleura::NodeRegistry* registry) { registerNodes(*registry); } \
  }
