#include <algorithm>

#include <fmt/format.h>
#include <unistd.h>

#include <pleura/x3d/browser/commands/progress.h>

namespace pleura {

void Progress::show(double done) {
  const int percent = static_cast<int>(100 * std::clamp(done, 0.0, 1.0));
  if (percent == lastPercent_ || isatty(STDERR_FILENO) == 0) return;
  lastPercent_ = percent;
  fmt::print(stderr, "\r{} {:3}%", what_, percent);
}

Progress::~Progress() {
  if (lastPercent_ >= 0) fmt::print(stderr, "\n");
}

}  // namespace pleura
