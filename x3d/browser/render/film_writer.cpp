#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <pleura/x3d/browser/render/film_writer.h>

namespace pleura::render {
namespace {

class SpawnActions {
 public:
  SpawnActions() { posix_spawn_file_actions_init(&actions_); }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  void redirect(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

std::string contents(int file) {
  std::string text(2000, '\0');
  const ssize_t size = pread(file, text.data(), text.size(), 0);
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void closeDescriptor(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

}  // namespace

FilmWriter::FilmWriter(const std::string& path, int width, int height, double framesPerSecond)
    : path_(path), partial_(path + ".part"), width_(width), height_(height) {
  if (!(framesPerSecond > 0 && framesPerSecond <= 1000))
    throw std::invalid_argument(fmt::format("framesPerSecond is {}, outside (0, 1000]", framesPerSecond));
  if (width < 1 || height < 1) throw std::invalid_argument(fmt::format("film of {} x {}", width, height));
  start(fmt::format("{}x{}", width, height), fmt::format("{}", framesPerSecond));
}

// A socket serves as the pipe: send() can be told not to raise SIGPIPE where ffmpeg has died, write() cannot.
void FilmWriter::start(const std::string& size, const std::string& rate) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error(fmt::format("{}: {}", path_, std::strerror(errno)));
  pipe_ = ends[0];
  words_ = memfd_create("ffmpeg", MFD_CLOEXEC);
  std::vector<std::string> words = {"ffmpeg",
                                    "-y",
                                    "-v",
                                    "error",
                                    "-f",
                                    "rawvideo",
                                    "-pix_fmt",
                                    "rgb24",
                                    "-s",
                                    size,
                                    "-r",
                                    rate,
                                    "-i",
                                    "pipe:0",
                                    "-vf",
                                    "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                    "-c:v",
                                    "libx264",
                                    "-pix_fmt",
                                    "yuv420p",
                                    "-movflags",
                                    "+faststart",
                                    "-f",
                                    "mp4",
                                    "file:" + partial_};
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  SpawnActions actions;
  actions.redirect(ends[1], STDIN_FILENO);
  actions.redirect(words_, STDERR_FILENO);
  const int error = posix_spawnp(&process_, "ffmpeg", actions.get(), nullptr, arguments.data(), environ);
  closeDescriptor(ends[1]);
  if (error == 0) return;
  process_ = -1;
  closeDescriptor(pipe_);
  closeDescriptor(words_);
  throw std::runtime_error(fmt::format("{}: films need the program ffmpeg: {}", path_, std::strerror(error)));
}

FilmWriter::~FilmWriter() {
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  finish();
}

void FilmWriter::write(const Image& frame) {
  if (frame.width != width_ || frame.height != height_)
    throw std::invalid_argument(
        fmt::format("frame of {} x {} in a film of {} x {}", frame.width, frame.height, width_, height_));
  if (process_ < 0) throw std::runtime_error(path_ + ": the film is closed");
  for (std::size_t done = 0; done < frame.pixels.size();) {
    const ssize_t sent = send(pipe_, frame.pixels.data() + done, frame.pixels.size() - done, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return close();
    done += static_cast<std::size_t>(sent);
  }
}

void FilmWriter::close() {
  if (process_ < 0) return;
  const auto [done, words] = finish();
  if (!done) throw std::runtime_error(fmt::format("{}: ffmpeg failed: {}", path_, words));
}

FilmWriter::Outcome FilmWriter::finish() {
  closeDescriptor(pipe_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  Outcome outcome{WIFEXITED(status) && WEXITSTATUS(status) == 0, contents(words_)};
  closeDescriptor(words_);
  std::error_code error;
  if (outcome.done) std::filesystem::rename(partial_, path_, error);
  if (error) outcome = {false, error.message()};
  if (!outcome.done) std::filesystem::remove(partial_, error);
  return outcome;
}

}  // namespace pleura::render
