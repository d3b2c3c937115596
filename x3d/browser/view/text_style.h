#pragma once

#include <pleura/nodes/standard/text/text.h>
#include <pleura/x3d/browser/render/text_geometry.h>

namespace pleura {

/// Changes whenever what layOut() reads may have changed.
std::uint64_t textStamp(Text& text);

/// The text as triangles; nothing for sizes that make no sense.
render::TextGeometry layOut(Text& text);

}  // namespace pleura
