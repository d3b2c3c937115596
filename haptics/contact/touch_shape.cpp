#include <cmath>

#include <pleura/haptics/contact/touch_shape.h>

namespace pleura::haptics {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

Vector3d unitNormal(const Corners& c) {
  const Vector3d normal = (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0));
  const double length = normal.norm();
  return length > 0 ? Vector3d(normal / length) : Vector3d::Zero();
}

Vector3d placeOf(const TouchMeshFrame& frame, int point) {
  return frame.points[point].head<3>().cast<double>();
}

double angleAt(const Corners& c, int k) {
  const Vector3d u = c.col((k + 1) % 3) - c.col(k), v = c.col((k + 2) % 3) - c.col(k);
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

Corners cornersOf(const TouchShape& shape, int triangle) {
  const Vector3i& t = shape.mesh->triangles()[triangle];
  const bool moves = shape.from != shape.to;
  Corners local;
  for (int k = 0; k < 3; ++k) {
    local.col(k) = placeOf(*shape.from, t[k]);
    if (moves) local.col(k) += double(shape.s) * (placeOf(*shape.to, t[k]) - local.col(k));
  }
  return (shape.pose.linear() * local).colwise() + shape.pose.translation();
}

Vector3d outward(const TouchShape& shape, int triangle, const Vector3d& weights) {
  const TouchMesh& mesh = *shape.mesh;
  int first = 0;
  weights.maxCoeff(&first);
  const int next = (first + 1) % 3, last = (first + 2) % 3;
  const bool onNext = weights[next] > 0, onLast = weights[last] > 0;
  if (onNext && onLast) return unitNormal(cornersOf(shape, triangle));

  const Vector3i& corners = mesh.triangles()[triangle];
  const int corner = mesh.welded(corners[first]);
  const bool onEdge = onNext || onLast;
  const int other = mesh.welded(corners[onNext ? next : last]);
  Vector3d sum = Vector3d::Zero();
  for (const int t : mesh.incident(corner)) {
    int at = -1;
    bool usesOther = false;
    for (int k = 0; k < 3; ++k) {
      const int welded = mesh.welded(mesh.triangles()[t][k]);
      if (welded == corner) at = k;
      usesOther = usesOther || welded == other;
    }
    if (onEdge && !usesOther) continue;
    const Corners c = cornersOf(shape, t);
    sum += (onEdge ? 1.0 : angleAt(c, at)) * unitNormal(c);
  }
  return sum;
}

}  // namespace pleura::haptics
