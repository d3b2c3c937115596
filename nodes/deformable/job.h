#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <utility>

namespace pleura {

/// Work that a helper thread may do while others is done here, or that is done here once it is needed: the
/// same answer either way. Helpers start with the first offer, one a core beyond the first. All functions
/// belong to one thread.
class Job {
 public:
  /// `work` may throw; what it uses lives longer than the job.
  explicit Job(std::function<void()> work) : work_(std::move(work)) {}
  ~Job() { cancel(); }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Lets a helper begin, unless it took so little last time that it is done sooner here. Offered already:
  /// nothing happens.
  void offer();
  /// Returns when the work is done: does it here where no helper has begun. Rethrows what it threw.
  void finish();
  /// Takes the offer back; waits where a helper has begun, and drops what was thrown.
  void cancel();

 private:
  friend class Helpers;
  using Clock = std::chrono::steady_clock;
  enum class Stage { idle, waiting, running, done };

  void run() noexcept;

  std::function<void()> work_;
  std::exception_ptr thrown_;
  Clock::duration lastTook_ = Clock::duration::max();
  Stage stage_ = Stage::idle;  // under Helpers' lock
};

/// How many threads work from now on, this one among them; 1: all is done here. Waits for those that run.
void setThreads(int count);

}  // namespace pleura
