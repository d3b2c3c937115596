#pragma once

#include <string>

#include <pleura/fields/field_declaration.h>

namespace pleura {

/// What numbers a field takes, for people: "0 to 1", "above 0, at most 1e+12". Empty: any.
std::string rangeText(const FieldDeclaration& declaration);

}  // namespace pleura
