#include <numeric>

#include <pleura/nodes/standard/rendering/triangulation.h>

namespace pleura {

namespace {

constexpr std::uint32_t kMostToClip = 4096;

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the signed area of a triangle: positive when it turns counterclockwise.
double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) { return cross(b - a, c - a); }

bool isInside(const Vec2d& p, const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// The corners of a face in its plane, counterclockwise: the axis nearest to the area vector is left out.
std::vector<Vec2d> flattened(const FaceList& faces, std::size_t face, std::span<const Vec3f> points) {
  const Vec3d area = areaVector(faces, face, points);
  Eigen::Index axis = 0;
  area.cwiseAbs().maxCoeff(&axis);
  Eigen::Index x = (axis + 1) % 3;
  Eigen::Index y = (axis + 2) % 3;
  if (area[axis] < 0) std::swap(x, y);
  std::vector<Vec2d> flat;
  for (auto corner = faces.begin(face); corner < faces.end(face); ++corner) {
    const Vec3f& p = points[static_cast<std::size_t>(faces.corners[corner].point)];
    flat.emplace_back(p[x], p[y]);
  }
  return flat;
}

/// Whether the corner `at` of what is left can be cut off: it is convex and holds no other corner.
bool isEar(const std::vector<std::uint32_t>& left, std::size_t at, const std::vector<Vec2d>& flat) {
  const std::size_t n = left.size();
  const Vec2d& a = flat[left[(at + n - 1) % n]];
  const Vec2d& b = flat[left[at]];
  const Vec2d& c = flat[left[(at + 1) % n]];
  if (turn(a, b, c) <= 0) return false;
  for (std::size_t i = 2; i < n - 1; ++i) {
    const Vec2d& p = flat[left[(at + i) % n]];
    if (p != a && p != b && p != c && isInside(p, a, b, c)) return false;
  }
  return true;
}

void clipEars(const FaceList& faces, std::size_t face, std::span<const Vec3f> points,
              std::vector<std::uint32_t>& triangles) {
  const std::uint32_t first = faces.begin(face);
  const std::vector<Vec2d> flat = flattened(faces, face, points);
  std::vector<std::uint32_t> left(flat.size());
  std::iota(left.begin(), left.end(), 0u);
  std::size_t at = 0;
  std::size_t refused = 0;
  while (left.size() > 2) {
    const std::size_t n = left.size();
    at %= n;
    if (n > 3 && refused < n && !isEar(left, at, flat)) {
      ++at;
      ++refused;
      continue;
    }
    for (const std::size_t corner : {at + n - 1, at, at + 1}) triangles.push_back(first + left[corner % n]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    at += left.size() - 1;  // one back: cutting may have made an ear of the corner before
    refused = 0;
  }
}

void cutAsFan(const FaceList& faces, std::size_t face, std::vector<std::uint32_t>& triangles) {
  const std::uint32_t first = faces.begin(face);
  for (std::uint32_t corner = first + 2; corner < faces.end(face); ++corner)
    triangles.insert(triangles.end(), {first, corner - 1, corner});
}

}  // namespace

Vec3d areaVector(const FaceList& faces, std::size_t face, std::span<const Vec3f> points) {
  const auto point = [&](std::uint32_t corner) -> Vec3d {
    return points[static_cast<std::size_t>(faces.corners[corner].point)].cast<double>();
  };
  const Vec3d origin = point(faces.begin(face));
  Vec3d twice = Vec3d::Zero();
  for (auto corner = faces.begin(face) + 2; corner < faces.end(face); ++corner)
    twice += (point(corner - 1) - origin).cross(point(corner) - origin);
  return twice / 2;
}

std::vector<std::uint32_t> triangulate(const FaceList& faces, std::span<const Vec3f> points, bool areConvex) {
  std::vector<std::uint32_t> triangles;
  triangles.reserve(3 * faces.corners.size());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const std::uint32_t count = faces.end(face) - faces.begin(face);
    if (areConvex || count <= 3 || count > kMostToClip) {
      cutAsFan(faces, face, triangles);
    } else {
      clipEars(faces, face, points, triangles);
    }
  }
  return triangles;
}

}  // namespace pleura
