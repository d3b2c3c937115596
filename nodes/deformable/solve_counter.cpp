#include <pleura/nodes/deformable/solve_counter.h>

namespace pleura {

std::uint64_t& solveCounter() {
  thread_local std::uint64_t solves = 0;
  return solves;
}

}  // namespace pleura
