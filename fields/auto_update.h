#pragma once

#include <pleura/fields/field.h>

namespace pleura {

/// A field that evaluates itself after every event, whether anybody reads it or not: for side effects.
template <class Base>
class AutoUpdate : public Base {
 public:
  AutoUpdate() { this->observesEvents(); }

 protected:
  void afterEvents() override { this->upToDate(); }
};

}  // namespace pleura
