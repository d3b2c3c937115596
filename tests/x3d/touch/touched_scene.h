#pragma once

#include <fmt/format.h>

#include <pleura/tests/x3d/browser/load_scene.h>
#include <pleura/x3d/browser/playback/playback.h>

namespace pleura {

/// A block of 20 cm whose front is the plane z = 0, of that surface, and a stylus that comes down on its
/// middle, centre `depth` metres deeper than it can get, within a second.
inline std::string blockAndStylus(const std::string& surface, double depth, const std::string& more = {}) {
  constexpr double kRadius = 0.0025;
  return fmt::format(
      "<Transform translation='0 0 -0.1'><Shape DEF='BLOCK'><Appearance>{}</Appearance>"
      "<Box DEF='BOX' size='0.2 0.2 0.2'/></Shape></Transform>"
      "<DeviceInfo><SimulatedDevice DEF='STYLUS' handStiffness='5000' handDamping='20' key='0 1' "
      "keyValue='0 0 0.05 0 0 {}' {}/></DeviceInfo>",
      surface, kRadius - depth, more);
}

}  // namespace pleura
