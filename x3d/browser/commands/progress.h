#pragma once

#include <string>

namespace pleura {

/// A line on a terminal that shows how far long work is; nothing where stderr is no terminal.
class Progress {
 public:
  explicit Progress(std::string what) : what_(std::move(what)) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` in [0, 1].
  void show(double done);

 private:
  std::string what_;
  int lastPercent_ = -1;
};

}  // namespace pleura
