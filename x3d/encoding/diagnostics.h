#pragma once

#include <string>
#include <vector>

namespace pleura {

/// A place in a file, counted from 1; line 0: the file as a whole.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Something that a scene's author should know, said in one sentence that names the node and the field.
struct Diagnostic {
  enum class Severity { warning, error };
  Severity severity = Severity::error;
  Place place;
  std::string message;
};

/// Every fault found in one run, in the order it was found. A fault repeated without end is told a limited
/// number of times, and counted.
class Diagnostics {
 public:
  void warn(const Place& place, std::string message) {
    add({Diagnostic::Severity::warning, place, std::move(message)});
  }
  void error(const Place& place, std::string message) {
    add({Diagnostic::Severity::error, place, std::move(message)});
  }

  const std::vector<Diagnostic>& all() const { return all_; }
  std::size_t warnings() const { return warnings_; }
  std::size_t errors() const { return errors_; }
  /// Whether what is found from now on is counted only: its wording takes no pains.
  bool isFull() const { return all_.size() >= kMostListed; }
  /// How many were found beyond those that are listed.
  std::size_t unlisted() const { return warnings_ + errors_ - all_.size(); }

 private:
  static constexpr std::size_t kMostListed = 1000;
  void add(Diagnostic diagnostic);

  std::vector<Diagnostic> all_;
  std::size_t warnings_ = 0;
  std::size_t errors_ = 0;
};

/// "file:line:column: error: message", what the place does not know left out.
std::string toText(const Diagnostic& diagnostic);
/// One line of JSON: file, line, column, severity, message.
std::string toJson(const Diagnostic& diagnostic);

}  // namespace pleura
