#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include <pleura/x3d/browser/view/offscreen_view.h>

namespace pleura {

/// What pictures look like.
struct PictureOptions {
  std::string size = "1280x720";
  std::string viewpoint;

  void addTo(CLI::App& command);
  int width() const { return side(0); }
  int height() const { return side(1); }
  /// Throws UsageError for a size or a viewpoint that makes no sense.
  std::unique_ptr<OffscreenView> view(Scene& scene) const;

 private:
  int side(int index) const;
};

}  // namespace pleura
