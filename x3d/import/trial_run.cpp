#include <chrono>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <pleura/x3d/import/trial_run.h>

namespace pleura {

namespace {

[[noreturn]] void runAndExit(const std::function<void()>& work) {
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
  for (const int crash : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) std::signal(crash, SIG_DFL);
  if (const int null = open("/dev/null", O_WRONLY); null >= 0) dup2(null, STDERR_FILENO);
  try {
    work();
  } catch (...) {
    _exit(0);
  }
  _exit(0);
}

}  // namespace

Trial tryInChild(const std::function<void()>& work, int seconds) {
  const pid_t child = fork();
  if (child < 0) return Trial::finished;
  if (child == 0) runAndExit(work);
  using namespace std::chrono;
  const auto end = steady_clock::now() + std::chrono::seconds(seconds);
  int status = 0;
  for (auto pause = 200us; waitpid(child, &status, WNOHANG) == 0; pause = std::min(2 * pause, 20000us)) {
    if (steady_clock::now() > end) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return Trial::hung;
    }
    std::this_thread::sleep_for(pause);
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Trial::finished : Trial::crashed;
}

}  // namespace pleura
