#include <pthread.h>
#include <time.h>

#include <pleura/haptics/servo/servo_loop.h>

namespace pleura::haptics {

namespace {

constexpr double kNanoseconds = 1e9;

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * static_cast<std::int64_t>(kNanoseconds) + time.tv_nsec;
}

void sleepUntil(std::int64_t nanoseconds) {
  const timespec time{.tv_sec = nanoseconds / static_cast<std::int64_t>(kNanoseconds),
                      .tv_nsec = nanoseconds % static_cast<std::int64_t>(kNanoseconds)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) != 0) {
  }
}

bool askForRealTime() {
  const sched_param priority{.sched_priority = 80};
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) == 0;
}

}  // namespace

ServoLoop::ServoLoop(Servo& servo, double time, bool wantsRealTime)
    : servo_(servo), thread_([this, time, wantsRealTime] { run(time, wantsRealTime); }) {}

ServoLoop::~ServoLoop() {
  shallStop_.store(true, std::memory_order_relaxed);
  thread_.join();
}

void ServoLoop::run(double time, bool wantsRealTime) {
  if (wantsRealTime) isRealTime_.store(askForRealTime(), std::memory_order_relaxed);
  const auto period = static_cast<std::int64_t>(servo_.period() * kNanoseconds);
  const std::int64_t start = now();
  std::int64_t deadline = start;
  std::int64_t last = start - period;
  while (!shallStop_.load(std::memory_order_relaxed)) {
    const std::int64_t begin = now();
    const bool isMissed = begin - deadline >= period;
    if (isMissed) deadline += (begin - deadline) / period * period;  // those that have passed are lost
    periods_.add(static_cast<double>(begin - last) / kNanoseconds, isMissed);
    last = begin;
    servo_.tick(time + static_cast<double>(begin - start) / kNanoseconds, isMissed);
    lastDuration_.store(static_cast<double>(now() - begin) / kNanoseconds, std::memory_order_relaxed);
    deadline += period;
    sleepUntil(deadline);
  }
}

}  // namespace pleura::haptics
