#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <pleura/x3d/browser/playback/playback.h>
#include <pleura/x3d/browser/scene/scene.h>

namespace pleura {

/// The options that `run`, `render` and `play` share.
struct SceneOptions {
  std::filesystem::path file;
  std::filesystem::path anatomy;
  bool allowOutside = false;
  std::optional<int> threads;
  PlaybackOptions playback;
  bool stats = false;
  bool hash = false;

  void addTo(CLI::App& command);
  void addPlaybackTo(CLI::App& command);

  /// Loads the file and prints every diagnostic to stderr. Throws Fault when the scene has errors.
  std::unique_ptr<Scene> load() const;
  /// Prints what was found while the scene ran, and what --stats and --hash ask for.
  void report(Scene& scene, const Playback& playback) const;

 private:
  void tellDiagnostics(const Scene& scene) const;
  mutable std::size_t told_ = 0;
};

}  // namespace pleura
