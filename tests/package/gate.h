#pragma once

#include <pleura/fields/typed_field.h>

/// Lets its number through while its switch is on.
class Gate : public pleura::TypedField<pleura::SFFloat, pleura::Types<pleura::SFBool, pleura::SFFloat>> {
  void update() override {
    const bool open = static_cast<pleura::SFBool*>(routes_in[0])->getValue();
    value = open ? static_cast<pleura::SFFloat*>(routes_in[1])->getValue() : 0;
  }
};
