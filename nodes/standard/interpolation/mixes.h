#pragma once

#include <pleura/fields/values.h>

namespace pleura {

/// The shorter way round from turn to turn, at an even speed.
struct RotationMix {
  static Rotation mix(const Rotation& a, const Rotation& b, float share);
};

/// Along the great circle from unit vector to unit vector.
struct NormalMix {
  static Vec3f mix(const Vec3f& a, const Vec3f& b, float share);
};

/// A straight line in hue, saturation and value, the shorter way round the hues (X3D 19.4.1).
struct ColorMix {
  static RGB mix(const RGB& a, const RGB& b, float share);
};

}  // namespace pleura
