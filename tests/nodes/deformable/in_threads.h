#pragma once

#include <pleura/nodes/deformable/job.h>

namespace pleura {

/// So many threads for as long as it lives, one afterwards.
class InThreads {
 public:
  explicit InThreads(int count) { setThreads(count); }
  ~InThreads() { setThreads(1); }
  InThreads(const InThreads&) = delete;
  InThreads& operator=(const InThreads&) = delete;
};

}  // namespace pleura
