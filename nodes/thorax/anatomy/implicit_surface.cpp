#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/thorax/anatomy/implicit_surface.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr int kRounds = 5;      // of smoothing along the skin, then back onto it
constexpr int kPasses = 3;      // of smoothing in a round
constexpr double kStep = 1e-5;  // [m] of the differences

// Samples of the solid at the nodes of a regular grid.
class Grid {
 public:
  Grid(const Solid& solid, const Eigen::AlignedBox3d& box, double spacing)
      : origin_(box.min()),
        spacing_(spacing),
        nodes_((box.sizes() / spacing).array().ceil().cast<int>() + 1) {
    values_.reserve(static_cast<std::size_t>(nodes_.prod()));
    for (int k = 0; k < nodes_.z(); ++k) {
      for (int j = 0; j < nodes_.y(); ++j) {
        for (int i = 0; i < nodes_.x(); ++i) {
          values_.push_back(solid(at({i, j, k})));
          const bool border = (Vector3i(i, j, k).array() == 0).any() ||
                              (Vector3i(i, j, k).array() == nodes_.array() - 1).any();
          if (border && values_.back() < 0.0) throw std::invalid_argument("skinOf: box: the solid leaves it");
        }
      }
    }
  }

  const Vector3i& nodes() const { return nodes_; }
  Vector3d at(const Vector3i& node) const { return origin_ + spacing_ * node.cast<double>(); }
  double value(const Vector3i& node) const { return values_[index(node)]; }
  std::size_t index(const Vector3i& node) const {
    return static_cast<std::size_t>(node.x() + nodes_.x() * (node.y() + nodes_.y() * node.z()));
  }
  std::size_t size() const { return values_.size(); }

 private:
  Vector3d origin_;
  double spacing_;
  Vector3i nodes_;
  std::vector<double> values_;
};

template <class Visit>
void forEachNode(const Vector3i& begin, const Vector3i& end, const Visit& visit) {
  for (int k = begin.z(); k < end.z(); ++k) {
    for (int j = begin.y(); j < end.y(); ++j) {
      for (int i = begin.x(); i < end.x(); ++i) visit(Vector3i(i, j, k));
    }
  }
}

// The mean of the points where the cell's twelve edges cross the skin; false if none does.
bool cellPoint(const Grid& grid, const Vector3i& cell, Vector3d& mean) {
  Vector3d sum = Vector3d::Zero();
  int crossings = 0;
  forEachNode(Vector3i::Zero(), Vector3i::Constant(2), [&](const Vector3i& corner) {
    for (int axis = 0; axis < 3; ++axis) {
      if (corner[axis] == 1) continue;
      const Vector3i a = cell + corner;
      const Vector3i b = a + Vector3i::Unit(axis);
      const double fa = grid.value(a);
      const double fb = grid.value(b);
      if ((fa < 0.0) == (fb < 0.0)) continue;
      sum += grid.at(a) + fa / (fa - fb) * (grid.at(b) - grid.at(a));
      ++crossings;
    }
  });
  if (crossings > 0) mean = sum / crossings;
  return crossings > 0;
}

struct Net {
  std::vector<Vector3d> points;
  std::vector<Vector3i> triangles;
};

void addQuad(Net& net, int a, int b, int c, int d) {
  const auto at = [&](int i) -> const Vector3d& { return net.points[static_cast<std::size_t>(i)]; };
  if ((at(a) - at(c)).squaredNorm() <= (at(b) - at(d)).squaredNorm()) {
    net.triangles.insert(net.triangles.end(), {{a, b, c}, {a, c, d}});
  } else {
    net.triangles.insert(net.triangles.end(), {{a, b, d}, {b, c, d}});
  }
}

Net surfaceNet(const Grid& grid) {
  Net net;
  std::vector<int> pointOfCell(grid.size(), -1);
  forEachNode(Vector3i::Zero(), grid.nodes() - Vector3i::Ones(), [&](const Vector3i& cell) {
    Vector3d point;
    if (!cellPoint(grid, cell, point)) return;
    pointOfCell[grid.index(cell)] = static_cast<int>(net.points.size());
    net.points.push_back(point);
  });
  forEachNode(Vector3i::Ones(), grid.nodes() - Vector3i::Ones(), [&](const Vector3i& node) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool inside = grid.value(node) < 0.0;
      if (inside == (grid.value(node + Vector3i::Unit(axis)) < 0.0)) continue;
      const Vector3i u = Vector3i::Unit((axis + 1) % 3);
      const Vector3i v = Vector3i::Unit((axis + 2) % 3);
      const auto cell = [&](const Vector3i& c) { return pointOfCell[grid.index(c)]; };
      const int a = cell(node - u - v);
      const int b = cell(node - v);
      const int c = cell(node);
      const int d = cell(node - u);
      inside ? addQuad(net, a, b, c, d) : addQuad(net, a, d, c, b);
    }
  });
  return net;
}

Vector3d gradient(const Solid& solid, const Vector3d& point, double value) {
  return {(solid(point + kStep * Vector3d::UnitX()) - value) / kStep,
          (solid(point + kStep * Vector3d::UnitY()) - value) / kStep,
          (solid(point + kStep * Vector3d::UnitZ()) - value) / kStep};
}

// Newton's step along the gradient, p <- p - f g / (g.g), no longer than a triangle; gives the normal.
Vector3d putOnSkin(const Solid& solid, Vector3d& point, double longest) {
  const double f = solid(point);
  const Vector3d g = gradient(solid, point, f);
  const Vector3d step = -f * g / std::max(g.squaredNorm(), 1e-2);
  point += step * std::min(1.0, longest / std::max(step.norm(), 1e-12));
  return g.normalized();
}

// Half a step to the mean of the neighbours, as far as it leads along the skin: evens out the triangles.
void smooth(std::vector<Vector3d>& points, const std::vector<Vector3d>& normals, const Adjacency& around) {
  const std::vector<Vector3d> before = points;
  for (int i = 0; i < around.rows(); ++i) {
    Vector3d mean = Vector3d::Zero();
    for (const int k : around[i]) mean += before[k];
    const Vector3d step = 0.5 * (mean / static_cast<double>(around[i].size()) - before[i]);
    points[i] += step - step.dot(normals[i]) * normals[i];
  }
}

}  // namespace

double smoothUnion(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - 0.25 * h * h * k;
}

double smoothIntersection(double a, double b, double k) { return -smoothUnion(-a, -b, k); }

double roundCone(const Vector3d& point, const Vector3d& a, double ra, const Vector3d& b, double rb) {
  const Vector3d axis = b - a;
  const double t = std::clamp((point - a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return (point - a - t * axis).norm() - (ra + t * (rb - ra));
}

TriangleMesh skinOf(const Solid& solid, const Eigen::AlignedBox3d& box, double spacing) {
  if (!(spacing > 0.0)) throw std::invalid_argument("skinOf: spacing: not positive");
  Net net = surfaceNet(Grid(solid, box, spacing));
  const Adjacency around = neighbours(net.points.size(), net.triangles);
  std::vector<Vector3d> normals(net.points.size());
  const auto project = [&] {
    for (std::size_t i = 0; i < net.points.size(); ++i) normals[i] = putOnSkin(solid, net.points[i], spacing);
  };
  project();
  for (int round = 0; round < kRounds; ++round) {
    for (int pass = 0; pass < kPasses; ++pass) smooth(net.points, normals, around);
    project();
  }
  project();
  TriangleMesh mesh;
  mesh.triangles = std::move(net.triangles);
  mesh.points.reserve(net.points.size());
  for (const Vector3d& point : net.points) mesh.points.push_back(point.cast<float>());
  return mesh;
}

}  // namespace pleura
