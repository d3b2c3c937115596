#pragma once

#include <limits>
#include <string>

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
};

}  // namespace pleura
