#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/triangle_geometry.h>

namespace pleura {

using Eigen::Vector3d;

namespace {

/// Nearest point of the edge from corner i to corner j.
TrianglePoint closestPointOnEdge(const Corners& corners, int i, int j, const Vector3d& p) {
  const Vector3d edge = corners.col(j) - corners.col(i);
  const double squaredLength = edge.squaredNorm();
  const double along = edge.dot(p - corners.col(i));
  const double t = squaredLength > 0 ? std::clamp(along / squaredLength, 0.0, 1.0) : 0.0;
  TrianglePoint nearest;
  nearest.weights.setZero();
  nearest.weights[i] = 1 - t;
  nearest.weights[j] = t;
  nearest.point = t < 1 ? Vector3d(corners.col(i) + t * edge) : Vector3d(corners.col(j));
  nearest.squaredDistance = (p - nearest.point).squaredNorm();
  return nearest;
}

/// sin^2 of a corner's angle below which a triangle counts as a line: there its normal is rounding.
constexpr double lineLike = 1e-22;

}  // namespace

TrianglePoint closestPointOnTriangle(const Corners& corners, const Vector3d& p) {
  const Vector3d ab = corners.col(1) - corners.col(0);
  const Vector3d ac = corners.col(2) - corners.col(0);
  const Vector3d ap = p - corners.col(0);
  const Vector3d n = ab.cross(ac);
  const double nn = n.squaredNorm();
  const bool isLine = nn <= lineLike * ab.squaredNorm() * ac.squaredNorm();
  // weights of p's projection times n.n: the areas of the triangles it makes with the edges
  Vector3d w(0, n.dot(ap.cross(ac)), n.dot(ab.cross(ap)));
  w[0] = nn - w[1] - w[2];
  if (!isLine && w.minCoeff() >= 0) {
    const double height = n.dot(ap);
    return {p - (height / nn) * n, w / nn, height * (height / nn)};
  }
  TrianglePoint nearest{Vector3d::Zero(), Vector3d::Zero(), std::numeric_limits<double>::infinity()};
  for (int k = 0; k < 3; ++k) {
    if (!isLine && w[k] >= 0) continue;  // p is on the inner side of the edge opposite corner k
    const TrianglePoint onEdge = closestPointOnEdge(corners, (k + 1) % 3, (k + 2) % 3, p);
    if (onEdge.squaredDistance < nearest.squaredDistance) nearest = onEdge;
  }
  return nearest;
}

Ray::Ray(const Vector3d& origin, const Vector3d& direction) : origin_(origin), direction_(direction) {
  direction.cwiseAbs().maxCoeff(&kz_);
  kx_ = (kz_ + 1) % 3;
  ky_ = (kz_ + 2) % 3;
  shear_ = Vector3d(direction[kx_], direction[ky_], 1) / direction[kz_];
}

std::optional<Ray::Hit> Ray::meet(const Corners& corners) const {
  Eigen::Matrix3d q;  // columns A, B, C sheared so that the ray runs along z
  for (int k = 0; k < 3; ++k) {
    const Vector3d v = corners.col(k) - origin_;
    q.col(k) << v[kx_] - shear_[0] * v[kz_], v[ky_] - shear_[1] * v[kz_], shear_[2] * v[kz_];
  }
  // U = Cx By - Cy Bx and so on: twice the areas of the triangles the ray makes with the edges
  Vector3d uvw;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    uvw[k] = q(0, j) * q(1, i) - q(1, j) * q(0, i);
  }
  if (uvw.minCoeff() < 0 && uvw.maxCoeff() > 0) return std::nullopt;
  const double det = uvw.sum();
  if (det == 0) return std::nullopt;
  return Hit{uvw.dot(q.row(2)) / det, uvw / det};
}

}  // namespace pleura
