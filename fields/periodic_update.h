#pragma once

#include <pleura/fields/field.h>

namespace pleura {

/// The fields of the calling thread that are evaluated once a tick.
class PeriodicFields {
 public:
  static void add(Field* field);
  static void remove(Field* field);
  /// Evaluates each, in the order they were made. Called by the scene at the end of its tick.
  static void upToDate();
};

/// A field that is evaluated once a tick, after everything else, whether anybody reads it or not.
template <class Base>
class PeriodicUpdate : public Base {
 public:
  PeriodicUpdate() { PeriodicFields::add(this); }
  ~PeriodicUpdate() override { PeriodicFields::remove(this); }
};

}  // namespace pleura
