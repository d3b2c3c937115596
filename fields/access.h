#pragma once

#include <cstdint>
#include <string_view>

namespace pleura {

/// Who may do what with a field of a node (X3D 4.0, 4.4.2.2). The node that owns the field is exempt.
enum class Access : std::uint8_t {
  inputOnly,       // set, never read
  outputOnly,      // read, never set
  initializeOnly,  // set while the scene loads, then as outputOnly
  inputOutput,     // set and read
};

std::string_view name(Access access);

constexpr bool canSet(Access access) { return access != Access::outputOnly; }
constexpr bool canGet(Access access) { return access != Access::inputOnly; }

}  // namespace pleura
