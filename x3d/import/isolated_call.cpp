#include <array>
#include <cerrno>
#include <cfenv>
#include <csignal>
#include <cstring>
#include <string_view>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <pleura/x3d/import/isolated_call.h>

namespace pleura {

namespace {

constexpr int returned = 0, threw = 3;

void writeAll(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) _exit(1);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string readAll(int file) {
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t size = read(file, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(size));
  }
}

void limit(__rlimit_resource resource, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(resource, &both);
}

/// The child's whole life. Its complaints are not the user's, and a crash is expected: no core, no handlers
/// of ours.
[[noreturn]] void live(const std::function<std::string()>& work, unsigned int seconds, int answer) {
  std::fesetenv(FE_DFL_ENV);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds);
  const int nowhere = open("/dev/null", O_WRONLY);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, output);
  try {
    writeAll(answer, work());
  } catch (const std::exception& error) {
    writeAll(answer, error.what());
    _exit(threw);
  }
  _exit(returned);
}

}  // namespace

std::string isolatedCall(const std::function<std::string()>& work, unsigned int seconds) {
  std::array<int, 2> ends;
  if (pipe(ends.data()) != 0) throw IsolationError(std::string("no pipe: ") + std::strerror(errno));
  const pid_t child = fork();
  if (child < 0) {
    for (const int end : ends) close(end);
    throw IsolationError(std::string("no process: ") + std::strerror(errno));
  }
  if (child == 0) live(work, seconds, ends[1]);
  close(ends[1]);
  std::string answer = readAll(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU || signal == SIGKILL)
    throw IsolationError("took more than " + std::to_string(seconds) + " s, or more memory than there is");
  if (signal != 0) throw IsolationError(std::string("crashed: ") + strsignal(signal));
  if (WEXITSTATUS(status) == threw) throw IsolationError(answer);
  if (WEXITSTATUS(status) != returned) throw IsolationError("crashed");
  return answer;
}

}  // namespace pleura
