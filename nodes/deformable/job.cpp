#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <pthread.h>
#include <sched.h>

#include <pleura/nodes/deformable/job.h>

namespace pleura {

/// About what a helper takes to wake.
constexpr auto kWorthAHelper = std::chrono::microseconds(50);

/// The threads of the program that do what is offered, first come first served.
class Helpers {
 public:
  static Helpers& all() {
    static Helpers helpers;
    return helpers;
  }
  ~Helpers() { stop(); }

  void setCount(int count) {
    stop();
    count_ = std::max(count, 0);
  }

  void offer(Job& job) {
    const std::lock_guard lock(mutex_);
    if (count_ == 0 || job.stage_ != Job::Stage::idle || job.lastTook_ < kWorthAHelper) return;
    start();
    keepHelpersAway();
    job.stage_ = Job::Stage::waiting;
    waiting_.push_back(&job);
    offered_.notify_one();
  }

  /// Does it here, or what else waits while a helper does it.
  void finish(Job& job) {
    std::unique_lock lock(mutex_);
    if (job.stage_ == Job::Stage::idle || std::erase(waiting_, &job) > 0) run(job, lock);
    while (job.stage_ == Job::Stage::running) {
      if (waiting_.empty())
        done_.wait(lock);
      else
        runFirst(lock);
    }
    job.stage_ = Job::Stage::idle;
  }

  void cancel(Job& job) {
    std::unique_lock lock(mutex_);
    std::erase(waiting_, &job);
    done_.wait(lock, [&job] { return job.stage_ != Job::Stage::running; });
    job.stage_ = Job::Stage::idle;
  }

 private:
  void start() {
    while (threads_.size() < static_cast<std::size_t>(count_)) threads_.emplace_back([this] { work(); });
  }

  /// From the core that offers: half of the time Linux would wake a helper there, though another is idle.
  void keepHelpersAway() {
    const int core = sched_getcpu();
    if (core == keptAwayFrom_) return;
    cpu_set_t others;
    if (sched_getaffinity(0, sizeof others, &others) != 0 || CPU_COUNT(&others) < 2) return;
    CPU_CLR(core, &others);
    for (std::thread& thread : threads_)
      pthread_setaffinity_np(thread.native_handle(), sizeof others, &others);
    keptAwayFrom_ = core;
  }

  void stop() {
    {
      const std::lock_guard lock(mutex_);
      isStopping_ = true;
    }
    offered_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    isStopping_ = false;
    keptAwayFrom_ = kNowhere;
  }

  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      offered_.wait(lock, [this] { return isStopping_ || !waiting_.empty(); });
      if (isStopping_) return;
      runFirst(lock);
    }
  }

  void runFirst(std::unique_lock<std::mutex>& lock) {
    Job& job = *waiting_.front();
    waiting_.erase(waiting_.begin());
    run(job, lock);
  }

  void run(Job& job, std::unique_lock<std::mutex>& lock) {
    job.stage_ = Job::Stage::running;
    lock.unlock();
    job.run();
    lock.lock();
    job.stage_ = Job::Stage::done;
    done_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable offered_, done_;
  std::vector<Job*> waiting_;
  std::vector<std::thread> threads_;
  static constexpr int kNowhere = -1;
  int keptAwayFrom_ = kNowhere;
  int count_ = std::max(static_cast<int>(std::thread::hardware_concurrency()), 1) - 1;
  bool isStopping_ = false;
};

void Job::offer() { Helpers::all().offer(*this); }

void Job::finish() {
  Helpers::all().finish(*this);
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Job::cancel() {
  Helpers::all().cancel(*this);
  thrown_ = nullptr;
}

void Job::run() noexcept {
  const auto begun = Clock::now();
  try {
    work_();
  } catch (...) {
    thrown_ = std::current_exception();
  }
  lastTook_ = Clock::now() - begun;
}

void setThreads(int count) { Helpers::all().setCount(count - 1); }

}  // namespace pleura
