#pragma once

namespace pleura {

/// X3D's numbers of the keys that make no character (ISO/IEC 19775-1, table 21.2). F1 to F12 are 1 to 12.
enum class ActionKey : int {
  f1 = 1,
  f12 = 12,
  home = 13,
  end = 14,
  pageUp = 15,
  pageDown = 16,
  up = 17,
  down = 18,
  left = 19,
  right = 20,
};

}  // namespace pleura
