#include <pleura/fields/counters.h>

namespace pleura {

FieldCounters& fieldCounters() {
  thread_local FieldCounters counters;
  return counters;
}

}  // namespace pleura
