#pragma once

#include <span>
#include <vector>

#include <pleura/nodes/deformable/fem/embedding.h>
#include <pleura/nodes/deformable/fem/linear_solid.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

struct FreedLungMaterial {
  double compliance = 1.02e-6;  ///< C [m^3/Pa] > 0 of the lung as it is at rest
  double poissonRatio = 0.3;    ///< nu, [0, 0.5)
  int elements = 300;           ///< wanted
};

struct FreedLungReport {
  double pressure = 0;  ///< q [Pa], above the transpulmonary pressure at rest
  int touching = 0;     ///< points that lie on the wall
  int solves = 0;
  bool hasConverged = false;
};

/// A lung that gas has set free from the wall: linear elasticity about its shape at rest, in which the
/// transpulmonary pressure of rest is in balance; held at the hilum, and kept inside the cavity by it,
/// without friction. Young's modulus follows from the compliance: with f = dV/dX and K of unit modulus,
///   E = f^T K^-1 f / C.
class FreedLung {
 public:
  /// `hilum`: points that are held. Throws std::invalid_argument as makeLattice does, on a material out of
  /// range, and where the hilum holds nothing.
  FreedLung(const TriangleMesh& rest, std::span<const int> hilum, const FreedLungMaterial& material);

  /// The shape of a lung of `volume` [m^3] inside a cavity, given as where each of its points would be on the
  /// wall:
  ///   K u + sum of k_i (n_i.(x_i - c_i))+ n_i = q f,  V(x) = volume.
  /// Each point has the wall's place and normal where it would itself be on it; what is outside then goes to
  /// the nearest place of the wall. Has no memory. Does not allocate; one call at a time. Where it has not
  /// converged, `points` are still inside the cavity.
  FreedLungReport shape(double volume, std::span<const Eigen::Vector3f> cavity,
                        std::span<Eigen::Vector3f> points);

  double youngsModulus() const { return youngsModulus_; }  ///< E [Pa]

 private:
  /// One unit of Young's modulus.
  FreedLung(const Lattice& lattice, const TriangleMesh& rest, std::span<const int> hilum,
            const FreedLungMaterial& material);
  void takeHilum(std::span<const Eigen::Vector3f> cavity);
  void addWall(std::span<const Eigen::Vector3f> cavity);
  /// Begins with the points that touched last: which touch in the end does not depend on that.
  void settle(double volume, std::span<const Eigen::Vector3f> cavity, std::span<Eigen::Vector3f> points,
              FreedLungReport& report);
  bool solve();
  /// Sets `points` to those of that volume; q.
  double inflate(double volume, std::span<Eigen::Vector3f> points) const;
  /// Each point that is outside goes to the wall. What is within the room around a neighbour that is inside
  /// is inside too.
  void keepInside(std::span<const Eigen::Vector3f> cavity, std::span<Eigen::Vector3f> points);
  /// How much room there is around the point, at least [m], once it is inside; `onWall` is a place of the
  /// wall.
  double keepInside(const Eigen::Vector3f& onWall, Eigen::Vector3f& point) const;
  /// Which points the wall holds; whether that has changed.
  bool touch(std::span<const Eigen::Vector3f> cavity, std::span<const Eigen::Vector3f> points);

  TriangleMesh rest_;
  std::vector<int> hilum_;
  Embedding embedding_;
  LinearSolid solid_;
  BlockCholesky factor_;
  NodeVectors pull_;          // f, of nodes
  std::vector<double> area_;  // of points [m^2]
  double youngsModulus_ = 1;

  // Work space.
  BlockValues system_;
  NodeVectors right_, held_, byWall_, byPressure_;  // of nodes
  std::vector<Eigen::Vector3d> base_, slope_;       // of points: x = base + q slope
  std::vector<Eigen::Vector3f> normals_;
  SurfaceQuery wall_;
  std::vector<float> room_;  // around points, without any wall [m]
  std::vector<char> touches_;
};

}  // namespace pleura
