#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace pleura {

/// A block of cubic cells along the axes; cell (i, j, k) has number i + n_x (j + n_y k).
struct LatticeGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // [m] low corner
  double cellSize = 1;                               // h [m]
  Eigen::Vector3i cells = Eigen::Vector3i::Zero();   // n along each axis

  /// What is nearer to a cell's face than this [cells] counts as on it.
  static constexpr double tolerance = 1e-6;

  int cellCount() const { return cells.prod(); }
  int cellNumber(const Eigen::Vector3i& cell) const {
    return cell.x() + cells.x() * (cell.y() + cells.y() * cell.z());
  }
  Eigen::Vector3i cellOf(int number) const {
    return {number % cells.x(), number / cells.x() % cells.y(), number / cells.x() / cells.y()};
  }

  /// In cells from the low corner.
  Eigen::Vector3d local(const Eigen::Vector3d& p) const { return (p - origin) / cellSize; }

  /// The cell that holds a place given in cells, or the one nearest to it.
  Eigen::Vector3i nearestCell(const Eigen::Vector3d& x) const {
    Eigen::Vector3i cell;
    for (int k = 0; k < 3; ++k) cell[k] = static_cast<int>(std::clamp(std::floor(x[k]), 0.0, cells[k] - 1.0));
    return cell;
  }

  /// Calls visit(number, cell) for each cell that a box given in cells touches.
  template <class Visit>
  void forEachCell(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Visit visit) const {
    const Eigen::Vector3i first = nearestCell(low), last = nearestCell(high);
    Eigen::Vector3i cell;
    for (cell.z() = first.z(); cell.z() <= last.z(); ++cell.z())
      for (cell.y() = first.y(); cell.y() <= last.y(); ++cell.y())
        for (cell.x() = first.x(); cell.x() <= last.x(); ++cell.x()) visit(cellNumber(cell), cell);
  }

  /// First cell chosen(number) that holds a place given in cells, on its faces too; -1: none.
  template <class Chosen>
  int cellAround(const Eigen::Vector3d& x, Chosen chosen) const {
    const auto beyond = (x.array() < -tolerance) || (x.array() > cells.cast<double>().array() + tolerance);
    int found = -1;
    if (!beyond.any())
      forEachCell(x.array() - tolerance, x.array() + tolerance, [&](int number, const Eigen::Vector3i&) {
        if (found < 0 && chosen(number)) found = number;
      });
    return found;
  }
};

}  // namespace pleura
