#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/thorax/anatomy/implicit_surface.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr int kRounds = 5;            // of smoothing along the skin, then back onto it
constexpr int kPasses = 3;            // of smoothing in a round
constexpr double kDifference = 1e-5;  // [m] of the differences

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
    const std::size_t rowsBefore = static_cast<std::size_t>(node.z()) * nodes_.y() + node.y();
    return rowsBefore * nodes_.x() + node.x();
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

// The twelve edges of a cell: edge 4 axis + u + 2 v runs along the axis, u and v tell its place on the next
// two.
constexpr int kEdges = 12;
int edgeOf(int axis, int u, int v) { return 4 * axis + u + 2 * v; }

struct Cell {
  std::array<bool, kEdges> crossed{};
  std::array<Vector3d, kEdges> crossing;
  std::array<int, kEdges> patch;  // the lowest edge of the piece of skin that an edge belongs to
  bool inside[2][2][2];

  Cell(const Grid& grid, const Vector3i& at) {
    std::iota(patch.begin(), patch.end(), 0);
    forEachNode(Vector3i::Zero(), Vector3i::Constant(2), [&](const Vector3i& c) {
      inside[c.x()][c.y()][c.z()] = grid.value(at + c) < 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        if (c[axis] == 0) cross(grid, at + c, axis, edgeOf(axis, c[(axis + 1) % 3], c[(axis + 2) % 3]));
      }
    });
    for (int axis = 0; axis < 3; ++axis) {
      joinOnFace(axis, 0);
      joinOnFace(axis, 1);
    }
  }

 private:
  void cross(const Grid& grid, const Vector3i& a, int axis, int edge) {
    const Vector3i b = a + Vector3i::Unit(axis);
    const double fa = grid.value(a);
    const double fb = grid.value(b);
    crossed[edge] = (fa < 0.0) != (fb < 0.0);
    if (crossed[edge]) crossing[edge] = grid.at(a) + fa / (fa - fb) * (grid.at(b) - grid.at(a));
  }

  void join(int e, int f) {
    const int low = std::min(patch[e], patch[f]);
    const int high = std::max(patch[e], patch[f]);
    std::replace(patch.begin(), patch.end(), high, low);
  }

  // The skin leaves a face of the cell along two of its edges, or, where the corners alternate, cuts off
  // either inside corner: both cells of the face see the same, so the pieces fit (Nielson 2004, dual marching
  // cubes).
  void joinOnFace(int normal, int side) {
    const int a = (normal + 1) % 3;
    const int b = (normal + 2) % 3;
    const auto alongA = [&](int atB) { return edgeOf(a, atB, side); };
    const auto alongB = [&](int atA) { return edgeOf(b, side, atA); };
    const auto isInside = [&](int atA, int atB) {
      Vector3i c;
      c[normal] = side;
      c[a] = atA;
      c[b] = atB;
      return inside[c.x()][c.y()][c.z()];
    };
    const std::array<int, 4> edges{alongA(0), alongA(1), alongB(0), alongB(1)};
    if (std::all_of(edges.begin(), edges.end(), [&](int e) { return crossed[e]; })) {
      for (int atA = 0; atA < 2; ++atA) join(alongB(atA), alongA(isInside(atA, 0) ? 0 : 1));
      return;
    }
    int first = -1;
    for (const int e : edges) {
      if (crossed[e] && first >= 0) join(first, e);
      if (crossed[e]) first = e;
    }
  }
};

// A point of the net for every piece of skin in the cell: the mean of its crossings.
void addPoints(const Cell& cell, Net& net, std::array<int, kEdges>& pointOf) {
  pointOf.fill(-1);
  for (int e = 0; e < kEdges; ++e) {
    if (!cell.crossed[e]) continue;
    if (cell.patch[e] != e) {
      pointOf[e] = pointOf[cell.patch[e]];
      continue;
    }
    Vector3d sum = Vector3d::Zero();
    int count = 0;
    for (int f = e; f < kEdges; ++f) {
      if (!cell.crossed[f] || cell.patch[f] != e) continue;
      sum += cell.crossing[f];
      ++count;
    }
    pointOf[e] = static_cast<int>(net.points.size());
    net.points.push_back(sum / count);
  }
}

Net surfaceNet(const Grid& grid) {
  Net net;
  std::vector<std::array<int, kEdges>> pointOf(grid.size());
  forEachNode(Vector3i::Zero(), grid.nodes() - Vector3i::Ones(),
              [&](const Vector3i& at) { addPoints(Cell(grid, at), net, pointOf[grid.index(at)]); });
  forEachNode(Vector3i::Ones(), grid.nodes() - Vector3i::Ones(), [&](const Vector3i& node) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool inside = grid.value(node) < 0.0;
      if (inside == (grid.value(node + Vector3i::Unit(axis)) < 0.0)) continue;
      const auto point = [&](int u, int v) {
        const Vector3i cell = node - u * Vector3i::Unit((axis + 1) % 3) - v * Vector3i::Unit((axis + 2) % 3);
        return pointOf[grid.index(cell)][edgeOf(axis, u, v)];
      };
      const int a = point(1, 1), b = point(0, 1), c = point(0, 0), d = point(1, 0);
      inside ? addQuad(net, a, b, c, d) : addQuad(net, a, d, c, b);
    }
  });
  return net;
}

Vector3d gradient(const Solid& solid, const Vector3d& point, double value) {
  return {(solid(point + kDifference * Vector3d::UnitX()) - value) / kDifference,
          (solid(point + kDifference * Vector3d::UnitY()) - value) / kDifference,
          (solid(point + kDifference * Vector3d::UnitZ()) - value) / kDifference};
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

Vector3d nearestOnSkin(const Solid& solid, const Vector3d& point, double longest) {
  Vector3d moved = point;
  putOnSkin(solid, moved, longest);
  return moved;
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
