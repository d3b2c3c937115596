#pragma once

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "icosphere.h"

#include <pleura/nodes/deformable/chainmail/chainmail_solver.h>

namespace pleura {

using Points = std::vector<Eigen::Vector3f>;

inline constexpr ChainmailMaterial kDiaphragm{0.7f, 1.1f, 0.1f};

/// A mesh ready to be pulled.
struct Organ {
  explicit Organ(TriangleMesh surface, std::vector<ChainmailMaterial> stuff = {ChainmailMaterial{}})
      : mesh(std::move(surface)),
        material(std::move(stuff)),
        model(makeChainmailModel(mesh.points, linkTriangles(mesh.points, mesh.triangles), material)),
        workspace(static_cast<int>(mesh.points.size())),
        positions(mesh.points) {}

  ChainmailReport pull(const std::vector<int>& driven, const Points& targets,
                       const ChainmailOptions& options = {}) {
    return solveChainmail(model, workspace, driven, targets, options, positions);
  }

  /// Where the points would be if they moved by these displacements.
  Points displaced(const std::vector<int>& driven, const Points& by) const {
    Points targets;
    for (std::size_t k = 0; k < driven.size(); ++k) targets.push_back(mesh.points[driven[k]] + by[k]);
    return targets;
  }

  TriangleMesh mesh;
  std::vector<ChainmailMaterial> material;
  ChainmailModel model;
  ChainmailWorkspace workspace;
  Points positions;
};

struct Violations {
  int count = 0;
  double worst = 0;  // [m]
};

/// The links of the positions beyond the box that Li and Brodlie give them, measured from the mesh in double
/// and apart from the solver's own code.
inline Violations violations(const Organ& organ, const Points& positions, double tolerance,
                             const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity()) {
  std::set<std::pair<int, int>> edges;
  for (const Eigen::Vector3i& t : organ.mesh.triangles)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  const auto materialOf = [&](int i) { return organ.material[organ.material.size() == 1 ? 0 : i]; };
  Violations found;
  for (const auto& [a, b] : edges) {
    const ChainmailMaterial ma = materialOf(a), mb = materialOf(b);
    const double compression = 0.5 * (double(ma.compression) + mb.compression);
    const double stretch = 0.5 * (double(ma.stretch) + mb.stretch),
                 shear = 0.5 * (double(ma.shear) + mb.shear);
    const Eigen::Vector3d d = (organ.mesh.points[b].cast<double>() - organ.mesh.points[a].cast<double>());
    const Eigen::Vector3d now =
        rotation.transpose() * (positions[b].cast<double>() - positions[a].cast<double>());
    double beyond = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double s = shear * (d.cwiseAbs().sum() - std::abs(d[axis]));
      const double shortest = compression * std::abs(d[axis]) - s, longest = stretch * std::abs(d[axis]) + s;
      const double along = d[axis] < 0 ? -now[axis] : now[axis];
      beyond = std::max({beyond, shortest - along, along - longest});
    }
    found.count += beyond > tolerance;
    found.worst = std::max(found.worst, beyond);
  }
  return found;
}

inline Eigen::Vector3f randomVector(std::mt19937& random, float size) {
  std::uniform_real_distribution<float> coordinate(-size, size);
  const float x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}

/// A few different points, in random order.
inline std::vector<int> randomPoints(std::mt19937& random, int count, int of) {
  std::set<int> chosen;
  std::vector<int> points;
  while (static_cast<int>(points.size()) < count) {
    const int point = static_cast<int>(random() % of);
    if (chosen.insert(point).second) points.push_back(point);
  }
  return points;
}

}  // namespace pleura
