#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// A measured point [mm; x left, y back, z up] in the subject's frame [m; x left, y up, z front], whose
/// origin is the table's (-1.15, -100, 1200): the mirror plane of the skeleton, the middle of the cage, the
/// height of the domes.
Eigen::Vector3d fromTableFrame(const Eigen::Vector3d& pointMm);

/// The same turn for a direction.
Eigen::Vector3d turnFromTableFrame(const Eigen::Vector3d& direction);

/// A comma separated table with a head line: its cells by row number and column name. Every read throws
/// std::invalid_argument if the column is missing or the cell is not a number.
class Table {
 public:
  Table(std::string_view name, std::span<const std::string_view> lines);

  std::size_t rows() const { return cells_.size(); }
  std::string_view text(std::size_t row, std::string_view column) const;
  double number(std::size_t row, std::string_view column) const;
  int integer(std::size_t row, std::string_view column) const;

  /// Columns PREFIXx_mm, PREFIXy_mm, PREFIXz_mm as a point of the subject's frame [m].
  Eigen::Vector3d point(std::size_t row, std::string_view prefix) const;
  /// Columns PREFIXx_1, PREFIXy_1, PREFIXz_1 as a unit vector of the subject's frame.
  Eigen::Vector3d direction(std::size_t row, std::string_view prefix) const;

 private:
  std::size_t column(std::string_view name) const;

  std::string name_;
  std::vector<std::string_view> columns_;
  std::vector<std::vector<std::string_view>> cells_;
};

}  // namespace pleura
