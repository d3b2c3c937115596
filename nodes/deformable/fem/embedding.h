#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/fem/lattice.h>

namespace pleura {

/// Points that ride in a lattice's elements: x_i = sum over a of w_ia X_a, X the element's nodes. The
/// functions below allocate nothing, and take spans as long as the points (or all nodes).
struct Embedding {
  std::vector<int> elements;    // one a point
  std::vector<int> nodes;       // eight a point: its element's
  std::vector<double> weights;  // w, eight a point, of sum 1
  int nodeCount = 0;            // of the lattice
  int outside = 0;              // points in no cell, tied to one near by: weights go below 0 and above 1

  int size() const { return static_cast<int>(elements.size()); }
};

/// Where points [m] are in the lattice at rest. Points of the surface it was made for are in cells; those
/// outside are extrapolated from the element the fewest cells away from the nearest cell of the grid. A point
/// on the face between two bodies rides with one of them. Throws std::invalid_argument on points that aren't
/// finite and on a lattice without elements.
Embedding embed(const Lattice& lattice, std::span<const Eigen::Vector3f> points);

/// Points [m] from nodes [m].
void interpolate(const Embedding& embedding, std::span<const Eigen::Vector3d> nodes,
                 std::span<Eigen::Vector3d> points);

/// Adds to the nodes' forces those [N] on the points: f_a += sum over i of w_ia f_i, of the same sum and the
/// same moment, and of the same power as the points move with the nodes.
void addTransposed(const Embedding& embedding, std::span<const Eigen::Vector3d> pointForces,
                   std::span<Eigen::Vector3d> nodeForces);

}  // namespace pleura
