#pragma once

#include <pleura/x3d/browser/anatomy/node_maker.h>

namespace pleura {

/// What a part is made of, as it looks and feels.
enum class Tissue { bone, cartilage, muscle, lung };

/// An Appearance for the tissue.
NodePtr appearanceOf(const NodeMaker& maker, Tissue tissue);

}  // namespace pleura
