#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <pleura/x3d/encoding/diagnostics.h>

namespace pleura {

namespace {

const char* name(Diagnostic::Severity severity) {
  return severity == Diagnostic::Severity::error ? "error" : "warning";
}

}  // namespace

void Diagnostics::add(Diagnostic diagnostic) {
  ++(diagnostic.severity == Diagnostic::Severity::error ? errors_ : warnings_);
  if (!isFull()) all_.push_back(std::move(diagnostic));
}

std::string toText(const Diagnostic& d) {
  std::string what = fmt::format("{}: {}", name(d.severity), d.message);
  if (d.place.file.empty()) return what;
  if (d.place.line == 0) return fmt::format("{}: {}", d.place.file, what);
  return fmt::format("{}:{}:{}: {}", d.place.file, d.place.line, d.place.column, what);
}

std::string toJson(const Diagnostic& d) {
  nlohmann::ordered_json json{{"file", d.place.file},
                              {"line", d.place.line},
                              {"column", d.place.column},
                              {"severity", name(d.severity)},
                              {"message", d.message}};
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace pleura
