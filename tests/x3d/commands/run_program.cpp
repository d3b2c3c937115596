#include <array>
#include <cstdio>
#include <stdexcept>

#include <sys/wait.h>

#include <pleura/tests/x3d/commands/run_program.h>

namespace pleura {

namespace {

std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  out += '\'';
  return out;
}

}  // namespace

Outcome runProgram(const std::vector<std::string>& arguments) {
  std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY timeout 60 " + quoted(PLEURA_PROGRAM);
  for (const auto& argument : arguments) {
    command += ' ';
    command += quoted(argument);
  }
  command += " 2>&1 </dev/null";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("can't run " + command);
  Outcome outcome;
  std::array<char, 4096> block{};
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), pipe))
    outcome.output.append(block.data(), got);
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

}  // namespace pleura
