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

void PeriodicFields::remove(Field* field) { std::erase(fields(), field); }

void PeriodicFields::upToDate() {
  for (std::size_t i = 0; i < fields().size(); ++i) fields()[i]->upToDate();
}

}  // namespace pleura
