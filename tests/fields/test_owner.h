#pragma once

#include <string>

#include <pleura/fields/field.h>

namespace pleura {

/// A node as far as fields know one.
struct TestOwner : FieldOwner {
  std::string describe() const override { return "RIB"; }
};

}  // namespace pleura
