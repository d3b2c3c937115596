#include <algorithm>
#include <vector>

#include <pleura/fields/periodic_update.h>

namespace pleura {

namespace {

std::vector<Field*>& fields() {
  thread_local std::vector<Field*> all;
  return all;
}

}  // namespace

void PeriodicFields::add(Field* field) { fields().push_back(field); }

/// The place stays until the end of the next tick: a field may be destroyed by the update() of another.
void PeriodicFields::remove(Field* field) {
  std::replace(fields().begin(), fields().end(), field, static_cast<Field*>(nullptr));
}

void PeriodicFields::upToDate() {
  for (std::size_t i = 0; i < fields().size(); ++i)
    if (Field* field = fields()[i]; field != nullptr) field->upToDate();
  std::erase(fields(), nullptr);
}

}  // namespace pleura
