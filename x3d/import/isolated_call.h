#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace pleura {

/// The work of an isolated call died or took too long; the message says which ("crashed: Segmentation
/// fault").
struct IsolationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs work() in a process of its own and returns what it returned, byte for byte. Whatever the work does to
/// its memory, the caller's stays whole. What it throws, a crash and more than `seconds` of processor time
/// come back as IsolationError. The work must not take locks that other threads may hold, since it runs after
/// a fork.
std::string isolatedCall(const std::function<std::string()>& work, unsigned int seconds);

}  // namespace pleura
