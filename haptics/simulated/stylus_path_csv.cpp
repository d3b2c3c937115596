#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <pleura/fields/nearest_name.h>
#include <pleura/haptics/simulated/stylus_path_csv.h>

namespace pleura::haptics {

namespace {

constexpr std::uintmax_t kLargestFile = 256'000'000;  // bytes
constexpr std::size_t kMostWaypoints = 1'000'000;
constexpr std::size_t kMostListed = 20;
constexpr std::size_t kMostQuoted = 40;

enum Column : std::size_t { time, x, y, z, qx, qy, qz, qw, buttons, kColumns };
constexpr std::array<std::string_view, kColumns> kColumnNames = {"time", "x",  "y",  "z",      "qx",
                                                                 "qy",   "qz", "qw", "buttons"};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string quoted(std::string_view text) {
  return text.size() > kMostQuoted ? fmt::format("\"{}...\"", text.substr(0, kMostQuoted))
                                   : fmt::format("\"{}\"", text);
}

class PathReader {
 public:
  PathReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  StylusPath read() {
    if (const auto at = text_.find_first_of(std::string_view("\0\x01\x02\x03\x04\x05\x06\x07\x08", 9));
        at != std::string_view::npos)
      throw StylusPathError(fmt::format("{}: expected text, found a binary byte at {}", name_, at));
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    while (!text_.empty() && !isTooLong_) {
      const auto end = std::min(text_.find('\n'), text_.size());
      line_ = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++lineNumber_;
      if (const auto content = trimmed(line_); !content.empty() && content.front() != '#') readLine();
    }
    if (waypoints_.empty() && faults_ == 0) addFault({}, "expected rows of time, x, y, z, found none");
    if (faults_ > kMostListed) list_ += fmt::format("\n{}: and {} more", name_, faults_ - kMostListed);
    if (faults_ > 0) throw StylusPathError(list_);
    return StylusPath(std::move(waypoints_));
  }

 private:
  void readLine() {
    split();
    if (order_.empty()) {
      const bool isHeader = std::none_of(cells_.begin(), cells_.end(),
                                         [](auto cell) { return number<double>(cell).has_value(); });
      isHeader ? readHeader() : assumeOrder();
      if (isHeader || order_.empty()) return;
    }
    readRow();
  }

  void split() {
    cells_.clear();
    for (std::string_view rest = line_;;) {
      const auto end = std::min(rest.find(','), rest.size());
      cells_.push_back(trimmed(rest.substr(0, end)));
      if (end == rest.size()) return;
      rest.remove_prefix(end + 1);
      if (cells_.size() > kColumns) return;  // one too many is enough to say so
    }
  }

  void readHeader() {
    std::array<bool, kColumns> has{};
    for (const auto cell : cells_) {
      const auto found = std::find_if(kColumnNames.begin(), kColumnNames.end(),
                                      [cell](std::string_view known) { return isSameName(known, cell); });
      const auto column = static_cast<Column>(found - kColumnNames.begin());
      order_.push_back(column);
      if (column == kColumns) {
        addFault(cell, fmt::format("expected a column of {}, found {}{}", fmt::join(kColumnNames, ", "),
                                   quoted(cell), didYouMean(nearestName(cell, kColumnNames))));
      } else if (std::exchange(has[column], true)) {
        addFault(cell, fmt::format("expected each column once, found {} again", kColumnNames[column]));
      }
    }
    const bool hasOrientation = has[qx] || has[qy] || has[qz] || has[qw];
    for (const auto column : {time, x, y, z, qx, qy, qz, qw})
      if (!has[column] && (column <= z || hasOrientation))
        addFault({}, fmt::format("expected a column {}, found none", kColumnNames[column]));
    // Without knowing the columns every row would only repeat it.
    if (faults_ > 0) text_ = {};
  }

  void assumeOrder() {
    switch (cells_.size()) {
      case 4:
        order_ = {time, x, y, z};
        return;
      case 5:
        order_ = {time, x, y, z, buttons};
        return;
      case 8:
        order_ = {time, x, y, z, qx, qy, qz, qw};
        return;
      case 9:
        order_ = {time, x, y, z, qx, qy, qz, qw, buttons};
        return;
      default:
        addFault({}, fmt::format("expected 4, 5, 8 or 9 columns separated by commas (time, x, y, z, then "
                                 "qx, qy, qz, qw, then buttons), found {}",
                                 cells_.size() > kColumns ? "more" : std::to_string(cells_.size())));
        text_ = {};
    }
  }

  void readRow() {
    if (cells_.size() != order_.size()) {
      addFault({}, fmt::format("expected {} columns, found {}", order_.size(),
                               cells_.size() > kColumns ? "more" : std::to_string(cells_.size())));
      return;
    }
    if (waypoints_.size() == kMostWaypoints) {
      isTooLong_ = true;
      addFault({}, fmt::format("expected at most {} rows, found more", kMostWaypoints));
      return;
    }
    StylusWaypoint waypoint;
    std::array<double, kColumns> values = {0, 0, 0, 0, 0, 0, 0, 1, 0};
    bool isWhole = true;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const auto cell = cells_[i];
      if (order_[i] == buttons) {
        const auto bits = number<std::uint32_t>(cell);
        waypoint.buttons = bits.value_or(0);
        isWhole &= bits.has_value();
        if (!bits) addFault(cell, fmt::format("buttons: expected a whole number, found {}", quoted(cell)));
      } else {
        const auto value = number<double>(cell);
        values[order_[i]] = value.value_or(0);
        isWhole &= value.has_value();
        if (!value)
          addFault(cell,
                   fmt::format("{}: expected a number, found {}", kColumnNames[order_[i]], quoted(cell)));
      }
    }
    if (!isWhole) return;
    waypoint.time = values[time];
    waypoint.position = {values[x], values[y], values[z]};
    waypoint.orientation = Eigen::Quaterniond(values[qw], values[qx], values[qy], values[qz]);
    const auto found = StylusPath::fault(waypoint, waypoints_.empty() ? nullptr : &waypoints_.back());
    found.empty() ? waypoints_.push_back(waypoint) : addFault({}, found);
  }

  /// At the cell, or at the line's first column where none is to blame.
  void addFault(std::string_view cell, const std::string& message) {
    if (++faults_ > kMostListed) return;
    if (faults_ > 1) list_ += '\n';
    list_ += fmt::format("{}:{}:{}: {}", name_, std::max<std::size_t>(1, lineNumber_),
                         cell.data() == nullptr ? 1 : cell.data() - line_.data() + 1, message);
  }

  std::string_view text_;  // what is not read yet
  const std::string& name_;
  std::string_view line_;
  std::size_t lineNumber_ = 0;
  std::vector<std::string_view> cells_;
  std::vector<Column> order_;
  std::vector<StylusWaypoint> waypoints_;
  std::string list_;
  std::size_t faults_ = 0;
  bool isTooLong_ = false;
};

}  // namespace

StylusPath parseStylusPath(std::string_view text, const std::string& name) {
  return PathReader(text, name).read();
}

StylusPath readStylusPath(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw StylusPathError(name + ": there is no such file");
  if (!std::filesystem::is_regular_file(file, error))
    throw StylusPathError(name + ": expected a file of comma separated values");
  const auto size = std::filesystem::file_size(file, error);
  if (error || size > kLargestFile)
    throw StylusPathError(
        fmt::format("{}: expected at most {} MB, found more", name, kLargestFile / 1'000'000));
  std::string text(size, '\0');
  std::ifstream in(file, std::ios::binary);
  if (!in.read(text.data(), static_cast<std::streamsize>(size)))
    throw StylusPathError(name + ": can't be read");
  return parseStylusPath(text, name);
}

}  // namespace pleura::haptics
