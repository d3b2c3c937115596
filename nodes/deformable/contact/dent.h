#pragma once

#include <span>

#include <Eigen/Core>

namespace pleura {

/// Where and how far a ball is pressed into a soft surface.
struct Dent {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();   // [m] of the untouched surface
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit, out of the surface
  double depth = 0;                                  // [m] > 0
  double radius = 0.0025;                            // [m] of the ball
};

/// How far an elastic half-space sinks at a distance r from the middle of a ball's contact, as a part of the
/// depth in the middle, rho = r / a and a the contact's radius (Hertz; Johnson 1985, Contact
/// Mechanics, 3.41-42).
double hertzProfile(double rho);

/// Presses the dent into the surface: points near it move against its normal, less with distance, none beyond
/// six contact radii, and the surface at dent.point by exactly dent.depth. A mesh coarser than the contact is
/// dented as wide as its triangles. Returns whether it did: nothing moves for a dent that is not finite or
/// not on the surface. Linear in the triangles, does not allocate.
bool press(const Dent& dent, std::span<const Eigen::Vector3i> triangles, std::span<Eigen::Vector3f> points);

}  // namespace pleura
