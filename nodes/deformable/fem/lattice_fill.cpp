#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <pleura/nodes/deformable/fem/lattice_fill.h>
#include <pleura/nodes/deformable/mesh/disjoint_sets.h>
#include <pleura/nodes/deformable/mesh/triangle_box.h>

namespace pleura {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3i;

/// Where a line passes through a triangle.
struct Crossing {
  std::int64_t line;
  double at;  // along the line [cells]
  int part;
  int change;  // of the winding number, along the line

  auto key() const { return std::tuple(line, at, -change, part); }
};

/// The side from a to b met by the ray from p to higher y, p and sides seen as (y, z): +1 where it runs to
/// higher z, -1 to lower, 0 not met. `at` is where along x. Takes the same steps whichever way the side runs.
struct SideHit {
  int sense;
  double y, at;
};
SideHit meetSide(const Vector3d& a, const Vector3d& b, const Vector2d& p) {
  const bool aIsLow = a.z() <= p.y(), bIsLow = b.z() <= p.y();
  if (aIsLow == bIsLow) return {0, 0, 0};
  const Vector3d& low = aIsLow ? a : b;
  const Vector3d& high = aIsLow ? b : a;
  const double t = (p.y() - low.z()) / (high.z() - low.z());
  return {aIsLow ? 1 : -1, low.y() + t * (high.y() - low.y()), low.x() + t * (high.x() - low.x())};
}

/// The lines along one axis: each cell's face has density^2 of them, one in each row and one in each column
/// of a density^2 by density^2 grid.
class LineField {
 public:
  LineField(const LatticeGrid& grid, int axis, int density)
      : order_(axis, (axis + 1) % 3, (axis + 2) % 3), density_(density) {
    for (int k = 0; k < 3; ++k) cells_[k] = grid.cells[order_[k]];
  }

  /// Corners in cells, axes turned so that lines run along x.
  Corners turned(const Corners& corners) const {
    Corners result;
    for (int k = 0; k < 3; ++k) result.row(k) = corners.row(order_[k]);
    return result;
  }

  Vector3i cellOf(std::int64_t line, int along) const {
    Vector3i cell;
    cell[order_[0]] = along;
    cell[order_[1]] = static_cast<int>(line % columns()) / density_;
    cell[order_[2]] = static_cast<int>(line / columns()) / density_;
    return cell;
  }

  /// Calls visit(line, its place) for those whose squares touch the box.
  template <class Visit>
  void forEachLine(const Vector3d& low, const Vector3d& high, Visit visit) const {
    const auto index = [this](double x, int axis) {
      return static_cast<int>(std::clamp(std::floor(x * density_), 0.0, cells_[axis] * density_ - 1.0));
    };
    const int lastColumn = index(high.y(), 1), lastRow = index(high.z(), 2);
    for (int row = index(low.z(), 2); row <= lastRow; ++row)
      for (int column = index(low.y(), 1); column <= lastColumn; ++column)
        visit(row * columns() + column, Vector2d(place(column, row), place(row, column)));
  }

  int along() const { return cells_.x(); }

 private:
  std::int64_t columns() const { return std::int64_t{cells_.y()} * density_; }
  double place(int mine, int other) const { return (mine + (other % density_ + 0.5) / density_) / density_; }

  Vector3i order_;
  Vector3i cells_;
  int density_;
};

/// How often each part winds around a place that goes along a line. All in constant time in the mean, however
/// many parts lie on top of each other.
class PartWindings {
 public:
  explicit PartWindings(int parts) : parts_(static_cast<std::size_t>(parts)) {}

  int of(int part) const { return parts_[part].winding; }
  int total() const { return total_; }

  void add(int part, int change) {
    Part& changed = parts_[part];
    if (changed.winding == 0) {
      changed.entry = static_cast<int>(entries_.size());
      entries_.push_back(part);
      ++present_;
    }
    total_ += change;
    changed.winding += change;
    if (changed.winding == 0 && --present_ == 0) {
      entries_.clear();
      oldest_ = settled_ = 0;
    }
  }

  /// Calls unite(oldest, part) for the parts here that came since this was called last, and returns the
  /// oldest. There must be one.
  template <class Unite>
  int settle(Unite unite) {
    while (!isPresent(oldest_)) ++oldest_;
    const int oldest = entries_[oldest_];
    for (; settled_ < entries_.size(); ++settled_)
      if (isPresent(settled_)) unite(oldest, entries_[settled_]);
    return oldest;
  }

 private:
  struct Part {
    int winding = 0;
    int entry = 0;  // the last of its
  };

  /// Whether the part is still here and has not left and come again.
  bool isPresent(std::size_t entry) const {
    const Part& part = parts_[entries_[entry]];
    return part.winding != 0 && part.entry == static_cast<int>(entry);
  }

  std::vector<Part> parts_;
  std::vector<int> entries_;  // parts as they came, since there was none
  std::size_t oldest_ = 0, settled_ = 0;
  int present_ = 0, total_ = 0;
};

class Filler {
 public:
  Filler(const ClosedSurface& surface, const LatticeGrid& grid)
      : surface_(surface),
        grid_(grid),
        lastPart_(grid.cellCount(), -1),
        oneOf_(static_cast<std::size_t>(surface.partCount)) {
    result_.fill.assign(grid.cellCount(), 0);
  }

  LatticeFill run() {
    const double facets = grid_.cells.prod() * grid_.cells.cast<double>().cwiseInverse().sum();
    const int density = std::clamp(static_cast<int>(std::sqrt(mostLines / facets)), 1, mostDensity);
    requireFewSpans(density);
    for (int axis = 0; axis < 3; ++axis) fillAlong(LineField(grid_, axis, density), density);
    passThrough();
    for (double& fill : result_.fill)
      if (fill > 1 - 1e-9) fill = 1;
    const double cellVolume = std::pow(grid_.cellSize, 3);
    result_.volume *= cellVolume;
    result_.crossedVolume *= cellVolume;
    for (CellPart& entry : result_.parts) entry.part = oneOf_.find(entry.part);
    std::sort(result_.parts.begin(), result_.parts.end());
    const auto repeats = std::unique(result_.parts.begin(), result_.parts.end());
    result_.parts.erase(repeats, result_.parts.end());
    return std::move(result_);
  }

 private:
  static constexpr int mostDensity = 8;     // 192 lines a cell: a face between cells is off by 1/64
  static constexpr double mostLines = 8e6;  // in all, so that a fine grid takes fewer of them a cell
  static constexpr double mostSpans = 4e9;  // under a minute
  static constexpr std::size_t mostCrossings = std::size_t{1} << 25;
  static constexpr double longEnough = 1e-9;  // [cells] of a line, to count
  static constexpr double crossedEnough = 1e-3;

  Corners cornersOf(std::size_t triangle) const {
    Corners corners;
    for (int k = 0; k < 3; ++k)
      corners.col(k) = grid_.local(surface_.mesh.points[surface_.mesh.triangles[triangle][k]].cast<double>());
    return corners;
  }

  /// Cells and lines in the boxes around the triangles bound the time.
  void requireFewSpans(int density) const {
    double spans = 0;
    for (std::size_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
      const Corners corners = cornersOf(t);
      const Vector3i first = grid_.nearestCell(corners.rowwise().minCoeff());
      const Vector3i last = grid_.nearestCell(corners.rowwise().maxCoeff());
      const Vector3d sizes = (last - first + Vector3i::Ones()).cast<double>();
      spans += sizes.prod() * (1 + density * density * sizes.cwiseInverse().sum());
    }
    if (spans > mostSpans) throw std::invalid_argument("triangles: too many that span many cells");
  }

  void add(int cell, int part) {
    if (lastPart_[cell] == part) return;
    lastPart_[cell] = part;
    result_.parts.push_back({cell, part});
  }

  std::vector<Crossing> crossings(const LineField& lines) const {
    std::vector<Crossing> found;
    for (std::size_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
      const Corners v = lines.turned(cornersOf(t));
      lines.forEachLine(v.rowwise().minCoeff(), v.rowwise().maxCoeff(),
                        [&](std::int64_t line, const Vector2d& p) {
                          int winding = 0;
                          SideHit met[2] = {{0, 0, 0}, {0, 0, 0}};  // a plane cuts two sides or none
                          int count = 0;
                          for (int k = 0; k < 3; ++k) {
                            const SideHit hit = meetSide(v.col(k), v.col((k + 1) % 3), p);
                            if (hit.sense == 0) continue;
                            if (p.x() < hit.y) winding += hit.sense;
                            met[count++] = hit;
                          }
                          if (winding == 0) return;
                          const double part = (p.x() - met[0].y) / (met[1].y - met[0].y);
                          const double at = met[0].at + part * (met[1].at - met[0].at);
                          // Anticlockwise seen from higher x: it faces there, and the line leaves the body.
                          found.push_back({line, at, surface_.parts[t], -winding});
                        });
      if (found.size() > mostCrossings)
        throw std::invalid_argument("triangles: too many on top of each other");
    }
    std::sort(found.begin(), found.end(),
              [](const Crossing& a, const Crossing& b) { return a.key() < b.key(); });
    return found;
  }

  void fillAlong(const LineField& lines, int density) {
    const double share = 1.0 / (3 * density * density);
    const std::vector<Crossing> found = crossings(lines);
    PartWindings windings(surface_.partCount);
    for (std::size_t i = 0; i + 1 < found.size(); ++i) {
      const Crossing& from = found[i];
      const Crossing& to = found[i + 1];
      const bool leavesCavity = windings.of(from.part) < 0;
      windings.add(from.part, from.change);
      const int winding = windings.total();
      const double length = to.at - from.at;
      if (winding == 0 || length < longEnough) continue;  // so short a stretch may be two touching faces
      const int owner = windings.settle([this](int first, int part) { oneOf_.unite(first, part); });
      if (leavesCavity) oneOf_.unite(owner, from.part);
      if (windings.of(to.part) + to.change < 0) oneOf_.unite(owner, to.part);
      if (winding != 1 && length > crossedEnough) result_.crossedVolume += share * length;
      result_.volume += share * length;
      const int last = std::clamp(static_cast<int>(to.at), 0, lines.along() - 1);
      for (int k = std::clamp(static_cast<int>(from.at), 0, lines.along() - 1); k <= last; ++k) {
        const double inCell = std::min(to.at, k + 1.0) - std::max(from.at, double(k));
        if (inCell < LatticeGrid::tolerance) continue;
        const int cell = grid_.cellNumber(lines.cellOf(from.line, k));
        result_.fill[cell] += share * inCell;
        add(cell, owner);
      }
    }
  }

  /// Cells that triangles pass through; what only touches a face leaves the cell behind it out.
  void passThrough() {
    for (int t = 0; t < surface_.lidsBegin; ++t) {
      const Corners corners = cornersOf(t);
      const int part = surface_.parts[t];
      grid_.forEachCell(
          corners.rowwise().minCoeff(), corners.rowwise().maxCoeff(), [&](int number, const Vector3i& cell) {
            const Vector3d centre = cell.cast<double>().array() + 0.5;
            if (lastPart_[number] != part && meetsCube(corners, centre, 0.5 - LatticeGrid::tolerance))
              add(number, part);
          });
    }
    // What lies in faces alone, a sheet without volume, needs cells all the same.
    for (int t = 0; t < surface_.lidsBegin; ++t) {
      const Corners corners = cornersOf(t);
      for (int k = 0; k < 3; ++k)
        if (grid_.cellAround(corners.col(k), [this](int cell) { return lastPart_[cell] >= 0; }) < 0)
          add(grid_.cellNumber(grid_.nearestCell(corners.col(k))), surface_.parts[t]);
    }
  }

  const ClosedSurface& surface_;
  const LatticeGrid& grid_;
  std::vector<int> lastPart_;
  DisjointSets oneOf_;
  LatticeFill result_;
};

}  // namespace

LatticeFill fillLattice(const ClosedSurface& surface, const LatticeGrid& grid) {
  return Filler(surface, grid).run();
}

}  // namespace pleura
