#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <pleura/nodes/thorax/anatomy/measurements.h>
#include <pleura/nodes/thorax/anatomy/table.h>

namespace pleura {
namespace {

constexpr double kMetresPerMillimetre = 1e-3;

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

}  // namespace

Eigen::Vector3d turnFromTableFrame(const Eigen::Vector3d& direction) {
  return {direction.x(), direction.z(), -direction.y()};
}

Eigen::Vector3d fromTableFrame(const Eigen::Vector3d& pointMm) {
  const Eigen::Vector3d originMm(-1.15, -100.0, 1200.0);
  return kMetresPerMillimetre * turnFromTableFrame(pointMm - originMm);
}

Table::Table(std::string_view name, std::span<const std::string_view> lines) : name_(name) {
  if (lines.empty()) throw std::invalid_argument(fmt::format("table {}: not there", name));
  columns_ = split(lines.front());
  for (const std::string_view line : lines.subspan(1)) {
    cells_.push_back(split(line));
    if (cells_.back().size() != columns_.size()) {
      throw std::invalid_argument(fmt::format("table {}, row {}: {} cells in {} columns", name_,
                                              cells_.size(), cells_.back().size(), columns_.size()));
    }
  }
}

std::size_t Table::column(std::string_view name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end())
    throw std::invalid_argument(fmt::format("table {}: no column {}", name_, name));
  return static_cast<std::size_t>(found - columns_.begin());
}

std::string_view Table::text(std::size_t row, std::string_view name) const {
  return cells_.at(row)[column(name)];
}

double Table::number(std::size_t row, std::string_view name) const {
  const std::string_view cell = text(row, name);
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    throw std::invalid_argument(
        fmt::format("table {}, row {}, column {}: '{}' is not a finite number", name_, row + 1, name, cell));
  }
  return value;
}

int Table::integer(std::size_t row, std::string_view name) const {
  return static_cast<int>(number(row, name));
}

Eigen::Vector3d Table::point(std::size_t row, std::string_view prefix) const {
  return fromTableFrame({number(row, fmt::format("{}x_mm", prefix)),
                         number(row, fmt::format("{}y_mm", prefix)),
                         number(row, fmt::format("{}z_mm", prefix))});
}

Eigen::Vector3d Table::direction(std::size_t row, std::string_view prefix) const {
  return turnFromTableFrame({number(row, fmt::format("{}x_1", prefix)),
                             number(row, fmt::format("{}y_1", prefix)),
                             number(row, fmt::format("{}z_1", prefix))})
      .normalized();
}

Table measurementTable(std::string_view name) { return Table(name, measurementLines(name)); }

}  // namespace pleura
