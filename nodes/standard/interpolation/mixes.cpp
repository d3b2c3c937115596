#include <algorithm>
#include <cmath>

#include <pleura/nodes/standard/interpolation/mixes.h>

namespace pleura {

namespace {

/// Hue in sixths of a turn [0, 6), saturation and value in [0, 1] (Smith 1978).
struct Hsv {
  float h, s, v;
};

Hsv toHsv(const RGB& rgb) {
  Eigen::Index strongest = 0;
  const float v = rgb.maxCoeff(&strongest);
  const float range = v - rgb.minCoeff();
  if (!(range > 0)) return {0, 0, v};
  const float offset = (rgb[(strongest + 1) % 3] - rgb[(strongest + 2) % 3]) / range;
  const float h = static_cast<float>(2 * strongest) + offset;
  return {h < 0 ? h + 6 : h, range / v, v};
}

RGB toRgb(const Hsv& hsv) {
  const auto component = [&](float n) {
    const float k = std::fmod(n + hsv.h, 6.0f);
    return hsv.v - hsv.v * hsv.s * std::clamp(std::min(k, 4 - k), 0.0f, 1.0f);
  };
  return {component(5), component(3), component(1)};
}

}  // namespace

Rotation RotationMix::mix(const Rotation& a, const Rotation& b, float share) {
  return Rotation(a.quaternion().slerp(share, b.quaternion()));
}

Vec3f NormalMix::mix(const Vec3f& a, const Vec3f& b, float share) {
  const float angle = std::atan2(a.cross(b).norm(), a.dot(b));
  const float sine = std::sin(angle);
  const Vec3f mixed = sine > 1e-4f
                          ? Vec3f((std::sin((1 - share) * angle) * a + std::sin(share * angle) * b) / sine)
                          : Vec3f(a + share * (b - a));
  const float length = mixed.norm();
  return length > 0 ? Vec3f(mixed / length) : a;
}

RGB ColorMix::mix(const RGB& a, const RGB& b, float share) {
  Hsv from = toHsv(a);
  Hsv to = toHsv(b);
  if (from.s == 0) from.h = to.h;
  if (to.s == 0) to.h = from.h;
  const float turn = std::remainder(to.h - from.h, 6.0f);
  const float h = std::fmod(from.h + share * turn + 6, 6.0f);
  return toRgb({h, from.s + share * (to.s - from.s), from.v + share * (to.v - from.v)});
}

}  // namespace pleura
