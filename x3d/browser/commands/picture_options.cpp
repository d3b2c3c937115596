#include <charconv>

#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/picture_options.h>

namespace pleura {

void PictureOptions::addTo(CLI::App& command) {
  command.add_option("--size", size, "Width and height of the picture in pixels")->capture_default_str();
  command.add_option("--viewpoint", viewpoint, "DEF name of the viewpoint to look from");
}

int PictureOptions::side(int index) const {
  constexpr int kLargest = 8192;
  const auto cross = size.find('x');
  if (cross != std::string::npos) {
    const std::string part = index == 0 ? size.substr(0, cross) : size.substr(cross + 1);
    int pixels = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), pixels);
    if (error == std::errc() && end == part.data() + part.size() && pixels >= 1 && pixels <= kLargest)
      return pixels;
  }
  throw UsageError("--size: expected WIDTHxHEIGHT, 1 to 8192 pixels each, found " + size);
}

std::unique_ptr<OffscreenView> PictureOptions::view(Scene& scene) const {
  auto view = std::make_unique<OffscreenView>(scene, width(), height());
  if (!viewpoint.empty()) view->view().lookFrom(viewpoint);
  return view;
}

}  // namespace pleura
