#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include <pleura/fields/access.h>
#include <pleura/fields/field_type.h>
#include <pleura/fields/unit.h>

namespace pleura {

/// The one place where a field of a node type is declared: parser, writer, routes, reference pages and tests
/// all read it. Lives as long as the node type.
struct FieldDeclaration {
  std::string name;
  FieldType type = FieldType::SFBool;
  Access access = Access::inputOutput;
  Unit unit = Unit::none;
  double minimum = -std::numeric_limits<double>::infinity();  // of every component, inclusive
  double maximum = std::numeric_limits<double>::infinity();
  std::string meaning;  // one line for the reference

  bool isBounded() const { return std::isfinite(minimum) || std::isfinite(maximum); }
  /// Whether every number of the value is within the range; what has no numbers always is.
  template <class T>
  bool admits(const T& value) const {
    if constexpr (std::is_arithmetic_v<T>) {
      return static_cast<double>(value) >= minimum && static_cast<double>(value) <= maximum;
    } else if constexpr (requires { value.minCoeff(); }) {
      return admits(value.minCoeff()) && admits(value.maxCoeff());
    } else {
      return true;
    }
  }
};

}  // namespace pleura
