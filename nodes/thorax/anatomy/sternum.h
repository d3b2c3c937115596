#pragma once

#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// Manubrium, body and xiphoid from their horizontal sections (measurements/sternum.csv), blended into one
/// bone.
Sternum generateSternum();

}  // namespace pleura
