#pragma once

#include <string>

#include <sys/types.h>

#include <pleura/x3d/browser/render/image.h>

namespace pleura::render {

/// Writes a film (H.264, yuv420p, MP4) with the program ffmpeg, under a temporary name until it is complete.
class FilmWriter {
 public:
  /// Starts ffmpeg. Frames have even sides or gain a black row or column. Throws std::invalid_argument for a
  /// rate outside (0, 1000], std::runtime_error if ffmpeg cannot be started.
  FilmWriter(const std::string& path, int width, int height, double framesPerSecond);

  /// Gives up a film that close() has not finished: ends ffmpeg and removes the temporary file.
  ~FilmWriter();
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;

  /// Throws std::invalid_argument for another size, std::runtime_error with ffmpeg's words if it has failed.
  void write(const Image& frame);

  /// Waits for ffmpeg and gives the film its name. Throws std::runtime_error with ffmpeg's words if it has
  /// failed.
  void close();

 private:
  void start(const std::string& size, const std::string& rate);
  struct Outcome {
    bool done;
    std::string words;  // ffmpeg's or the file system's
  };
  Outcome finish();

  std::string path_, partial_;
  int width_, height_;
  int pipe_ = -1;   // to ffmpeg's standard input
  int words_ = -1;  // a file that takes ffmpeg's standard error
  pid_t process_ = -1;
};

}  // namespace pleura::render
