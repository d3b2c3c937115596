#pragma once

#include <utility>
#include <vector>

#include "geodesic_sphere.h"

#include <pleura/nodes/deformable/springs/spring_solver.h>

namespace pleura {

using Points = std::vector<Eigen::Vector3d>;

/// A surface of springs ready to be solved for.
struct ElasticSurface {
  explicit ElasticSurface(TriangleMesh surface, const SpringMaterial& material = {},
                          const SpringInterior& interior = EmptyInterior())
      : mesh(std::move(surface)),
        model(makeSpringModel(mesh.points, mesh.triangles, material, interior)),
        workspace(model),
        positions(model.rest),
        state(restingState(model)) {}

  SpringReport solve(const std::vector<int>& driven = {}, const Points& targets = {},
                     const SpringOptions& options = {}) {
    return solveSprings(model, workspace, driven, targets, options, positions);
  }

  SpringReport step(double seconds, const std::vector<int>& driven = {}, const Points& targets = {},
                    const SpringOptions& options = {}) {
    return stepSprings(model, workspace, driven, targets, seconds, options, state);
  }

  TriangleMesh mesh;
  SpringModel model;
  SpringWorkspace workspace;
  Points positions;
  SpringState state;
};

inline double largestDistance(const Points& a, const Points& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

/// The case of a balloon: a unit sphere of equal springs that holds a gas of n R T = 100 J in nothing.
inline ElasticSurface balloon(int cuts) {
  const double points = 10.0 * cuts * cuts + 2;
  return ElasticSurface(geodesicSphere(cuts, 1), {{1e4}, {1 / points}, 0}, GasInterior{100, 0});
}

}  // namespace pleura
