#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <pleura/haptics/contact/triangle_point.h>

namespace pleura::haptics {

using Eigen::Vector3d;

namespace {

/// sin^2 of a corner's angle below which a triangle counts as a line: there its area is nearly rounding.
constexpr double kLineLike = 1e-12;

TrianglePoint nearestOnEdges(const Corners& corners, const Vector3d& p) {
  TrianglePoint nearest{corners.col(0), Vector3d::UnitX()};
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vector3d edge = corners.col(j) - corners.col(i);
    const double squaredLength = edge.squaredNorm();
    const double along = edge.dot(p - corners.col(i));
    const double t = squaredLength > 0 ? std::clamp(along / squaredLength, 0.0, 1.0) : 0.0;
    const Vector3d point = corners.col(i) + t * edge;
    if ((p - point).squaredNorm() >= least) continue;
    least = (p - point).squaredNorm();
    nearest.point = point;
    nearest.weights.setZero();
    nearest.weights[i] = 1 - t;
    nearest.weights[j] = t;
  }
  return nearest;
}

}  // namespace

TrianglePoint nearestOnTriangle(const Corners& corners, const Vector3d& p) {
  const Vector3d a = corners.col(0), ab = corners.col(1) - a, ac = corners.col(2) - a, ap = p - a;
  // products of the edges at a with the ways from a, b and c to p
  const double abab = ab.squaredNorm(), acac = ac.squaredNorm(), abac = ab.dot(ac);
  const double abap = ab.dot(ap), acap = ac.dot(ap);
  if (abap <= 0 && acap <= 0) return {a, {1, 0, 0}};
  const double abbp = abap - abab, acbp = acap - abac;
  if (abbp >= 0 && acbp <= abbp) return {corners.col(1), {0, 1, 0}};
  const double abcp = abap - abac, accp = acap - acac;
  if (accp >= 0 && abcp <= accp) return {corners.col(2), {0, 0, 1}};
  const double nn = abab * acac - abac * abac;
  if (nn <= kLineLike * abab * acac) return nearestOnEdges(corners, p);
  const double wc = abap * acbp - abbp * acap;
  if (wc <= 0 && abap >= 0 && abbp <= 0) {
    const double t = abap / abab;
    return {a + t * ab, {1 - t, t, 0}};
  }
  const double wb = abcp * acap - abap * accp;
  if (wb <= 0 && acap >= 0 && accp <= 0) {
    const double t = acap / acac;
    return {a + t * ac, {1 - t, 0, t}};
  }
  const double wa = abbp * accp - abcp * acbp, toC = acbp - abbp, toB = abcp - accp;
  if (wa <= 0 && toC >= 0 && toB >= 0) {
    const double t = toC / (toC + toB);
    return {corners.col(1) + t * (corners.col(2) - corners.col(1)), {0, 1 - t, t}};
  }
  const double sum = wa + wb + wc;
  const Vector3d weights(wa / sum, wb / sum, wc / sum);
  return {a + weights[1] * ab + weights[2] * ac, weights};
}

}  // namespace pleura::haptics
