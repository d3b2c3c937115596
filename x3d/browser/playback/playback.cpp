#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include <pleura/x3d/browser/playback/playback.h>

namespace pleura {

Playback::Playback(Scene& scene, const PlaybackOptions& options)
    : scene_(scene),
      step_(options.step),
      keys_(parseKeys(options.keys)),
      touch_(scene, options.touch,
             options.isRealTime ? TouchSession::Clock::real : TouchSession::Clock::virtualTime),
      table_(scene, options.watch),
      csvFile_(options.csv),
      isRealTime_(options.isRealTime) {
  if (!std::isfinite(step_) || step_ < 1e-6 || step_ > 1e3)
    throw std::invalid_argument("step: expected 1e-6 to 1e3 seconds");
  for (const auto& assignment : options.set) scene.set(assignment);
  touch_.open();
  if (csvFile_.empty()) return;
  csv_.open(csvFile_);
  if (!csv_) throw FileError(csvFile_.string() + ": can't be written");
}

void Playback::runUntil(Time time, const std::function<void(Time)>& afterTick) {
  const auto last = static_cast<std::int64_t>(std::floor(time / step_ + 1e-9));
  while (ticks_ < last) {
    ++ticks_;
    if (isRealTime_) await(now());
    tick(now(), afterTick);
  }
  if (csv_.is_open() && !csv_.flush()) throw FileError(csvFile_.string() + ": can't be written");
}

void Playback::await(Time now) {
  using Clock = std::chrono::steady_clock;
  if (ticks_ == 0) start_ = Clock::now();
  std::this_thread::sleep_until(
      start_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(now)));
}

void Playback::tick(Time now, const std::function<void(Time)>& afterTick) {
  for (; nextKey_ < keys_.size() && keys_[nextKey_].time <= now; ++nextKey_) {
    KeyEvent event{.character = keys_[nextKey_].key};
    scene_.key(event);
    event.pressed = false;
    scene_.key(event);
  }
  statistics_.begin();
  scene_.tick(now);
  touch_.advance(now);
  if (afterTick) afterTick(now);
  if (csv_.is_open()) {
    if (ticks_ == 0) table_.writeHeader(csv_);
    table_.writeRow(csv_, now);
  }
  statistics_.end();
}

}  // namespace pleura
