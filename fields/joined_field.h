#pragma once

#include <pleura/fields/typed_field.h>

namespace pleura {

/// The values of all inputs, one input after the other in the order of the routes.
template <class MField>
class JoinedField : public TypedField<MField, AnyNumber<MField>> {
 protected:
  void update() override {
    this->value.clear();
    for (Field* input : this->routes_in) {
      const auto& part = static_cast<MField*>(input)->getValue();
      this->value.insert(this->value.end(), part.begin(), part.end());
    }
  }
};

}  // namespace pleura
