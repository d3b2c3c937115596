#pragma once

#include <functional>

namespace pleura {

/// What became of a trial run.
enum class Trial { finished, crashed, hung };

/// Runs `work` in a child process, a copy of this one, and throws its results away: whether code of others
/// survives this input can be known before this process risks it. What it throws counts as finished; it is
/// silent on stderr. Hung: not finished after `seconds`. A process that can't be copied counts as finished.
Trial tryInChild(const std::function<void()>& work, int seconds);

}  // namespace pleura
