#pragma once

#include <string>

#include <pleura/x3d/browser/render/draw_list.h>
#include <pleura/x3d/browser/render/image.h>

namespace pleura::render::test {

/// How far two pictures of one size are apart.
struct Difference {
  double mean = 0;     // over all bytes, of the absolute difference
  double maxTile = 0;  // the largest such mean over tiles of 16 x 16 pixels
};

Difference difference(const Image& a, const Image& b);

/// The list drawn by OSMesa at 320 x 240.
Image drawGolden(const DrawList& list);

/// Expects the picture to be golden/<name>.png within a mean of 0.5 and a tile mean of 4 of 255. A picture
/// that fails, or has no golden yet, is left beside the test program as <name>.actual.png for a person to
/// look at.
void expectGolden(const Image& image, const std::string& name);

}  // namespace pleura::render::test
