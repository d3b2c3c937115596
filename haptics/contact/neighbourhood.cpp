#include <algorithm>
#include <cmath>
#include <limits>

#include <pleura/haptics/contact/neighbourhood.h>

namespace pleura::haptics {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// The share of its radius by which the ball may overlap a shape and still be felt to touch it.
constexpr double kOverlap = 0.01;

/// So few triangles let a long way be looked at in one go.
constexpr int kFew = 16;

/// Gathering halves its reach at most so often.
constexpr int kMaxHalvings = 12;

/// Columns: along an edge of the triangle, across it, along the normal. False for a triangle without area.
bool frameOf(const Corners& c, Matrix3d& frame) {
  const Vector3d edge = c.col(1) - c.col(0), normal = edge.cross(c.col(2) - c.col(0));
  const double length = edge.norm(), area = normal.norm();
  if (length <= 0 || area <= 0) return false;
  frame.col(0) = edge / length;
  frame.col(2) = normal / area;
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return true;
}

bool stands(const Neighbourhood::Shape& before, const TouchShape& now) {
  const bool samePoints = before.from == now.from->serial && before.to == now.to->serial &&
                          (before.from == before.to || before.now.s == now.s);
  return samePoints && before.now.pose.matrix() == now.pose.matrix();
}

}  // namespace

void Neighbourhood::clear() {
  shapeCount_ = 0;
  count_ = 0;
  valid_ = false;
}

int Neighbourhood::find(std::uint32_t id) const {
  for (int k = 0; k < shapeCount_; ++k)
    if (shapes_[k].now.id == id) return k;
  return -1;
}

Neighbourhood::Nearest Neighbourhood::nearest(int shape, const Vector3d& point) const {
  Nearest least;
  least.distance = std::numeric_limits<float>::max();
  for (int i = 0; i < count_; ++i) {
    const Triangle& triangle = triangles_[i];
    const double within = least.distance + triangle.radius;
    if (triangle.shape != shape || (point - triangle.centre).squaredNorm() >= within * within) continue;
    const TrianglePoint on = nearestOnTriangle(triangle.corners, point);
    const double distance = (point - on.point).norm();
    if (distance < least.distance) least = {i, on, distance};
  }
  return least;
}

/// The ball's way with the triangle that is nearest to it; false where the shape stands still there.
bool Neighbourhood::carry(Shape& shape, const TouchShape& next, const Vector3d& position) const {
  shape.view = position;
  shape.motion.setZero();
  const Nearest at = nearest(static_cast<int>(&shape - shapes_.data()), position);
  if (at.triangle < 0) return false;
  const Corners& before = triangles_[at.triangle].corners;
  const Corners after = cornersOf(next, triangles_[at.triangle].index);
  if (before == after) return false;
  const Vector3d offset = position - at.on.point;
  Matrix3d frameBefore, frameAfter;
  const bool turns = frameOf(before, frameBefore) && frameOf(after, frameAfter);
  const Vector3d point = after * at.on.weights;
  shape.motion = point - at.on.point;
  shape.view = point + (turns ? Vector3d(frameAfter * (frameBefore.transpose() * offset)) : offset);
  return true;
}

void Neighbourhood::advance(std::span<const TouchShape> shapes, const Vector3d& position) {
  int kept = 0;
  std::array<bool, kMaxShapes> here{};
  for (int k = 0; k < shapeCount_; ++k) {
    Shape& shape = shapes_[k];
    const auto next = std::ranges::find(shapes, shape.now.id, &TouchShape::id);
    here[k] = next != shapes.end() && next->mesh->serial() == shape.mesh;
    if (!here[k]) {
      valid_ = false;
      continue;
    }
    if (stands(shape, *next)) {
      shape.view = position;
      shape.motion.setZero();
    } else {
      carry(shape, *next, position);
      valid_ = false;
    }
    shape.now = *next;
    shape.from = next->from->serial;
    shape.to = next->to->serial;
  }
  if (!valid_) {
    for (int k = 0; k < shapeCount_; ++k)
      if (here[k]) shapes_[kept++] = shapes_[k];
    shapeCount_ = kept;
    count_ = 0;
    return;
  }
  for (const TouchShape& shape : shapes)
    if (find(shape.id) < 0) visitNear(shape, centre_, reach_, [this](int) { return valid_ = false; });
}

/// False if there is no room for all triangles, unless a part will do.
bool Neighbourhood::collect(std::span<const TouchShape> shapes, const Vector3d& position, double radius,
                            double reach, bool partly) {
  count_ = 0;
  bool complete = true;
  const int known = shapeCount_;
  std::array<int, kMaxShapes> begin, end;
  for (int k = 0; k < known; ++k) begin[k] = end[k] = 0;
  for (const TouchShape& shape : shapes) {
    int k = find(shape.id);
    const bool isNew = k < 0;
    if (isNew) k = shapeCount_;
    const int first = count_;
    const Vector3d centre = isNew ? position : shapes_[k].view;
    visitNear(shape, centre, reach + (centre - position).norm(), [&](int index) {
      if (count_ == kMaxTriangles || k == kMaxShapes) return complete = false;
      Triangle& triangle = triangles_[count_++];
      triangle.corners = cornersOf(shape, index);
      triangle.centre = triangle.corners.rowwise().mean();
      triangle.radius =
          std::sqrt((triangle.corners.colwise() - triangle.centre).colwise().squaredNorm().maxCoeff());
      triangle.shape = k;
      triangle.index = index;
      return true;
    });
    if (isNew && count_ == first) continue;
    if (isNew) {
      shapes_[k] = {shape,    shape.mesh->serial(), shape.from->serial, shape.to->serial, true,
                    position, Vector3d::Zero()};
      ++shapeCount_;
      const Nearest at = nearest(k, position);
      const bool inFront =
          shape.surface.twoSided ||
          outward(shape, triangles_[at.triangle].index, at.on.weights).dot(position - at.on.point) >= 0;
      shapes_[k].felt = inFront && at.distance >= radius * (1 - kOverlap);
    }
    begin[k] = first;
    end[k] = count_;
  }
  if (!complete && !partly) {
    shapeCount_ = known;
    return false;
  }
  int kept = 0;
  for (int k = 0; k < shapeCount_; ++k) {
    if (begin[k] == end[k]) continue;
    for (int i = begin[k]; i < end[k]; ++i) triangles_[i].shape = kept;
    shapes_[kept++] = shapes_[k];
  }
  shapeCount_ = kept;
  return true;
}

double Neighbourhood::gather(std::span<const TouchShape> shapes, const Vector3d& position, double radius,
                             double reach) {
  if (valid_ && (position - centre_).norm() + reach <= reach_) return reach;
  const double slack = radius;  // so that the next ticks find theirs here too
  double room = std::min(reach, 4 * radius) + slack;
  for (int k = 0; !collect(shapes, position, radius, room, k == kMaxHalvings); ++k)
    room = radius + (room - radius) / 2;
  while (count_ < kFew && room < reach + slack) {
    const double wider = std::min(2 * room, reach + slack);
    if (!collect(shapes, position, radius, wider, false)) {
      collect(shapes, position, radius, room, true);
      break;
    }
    room = wider;
  }
  centre_ = position;
  reach_ = room;
  valid_ = true;
  return std::min(reach, room);
}

void Neighbourhood::moveTo(const Vector3d& position) {
  for (int k = 0; k < shapeCount_; ++k) shapes_[k].view = position;
}

void Neighbourhood::settle(const Vector3d& position, double radius) {
  for (int k = 0; k < shapeCount_; ++k) {
    Shape& shape = shapes_[k];
    const bool twoSided = shape.now.surface.twoSided;
    if (shape.felt && (twoSided || shape.now.mesh->isClosed())) continue;
    const Nearest at = nearest(k, position);
    if (at.triangle < 0) continue;
    const bool inFront =
        twoSided ||
        outward(shape.now, triangles_[at.triangle].index, at.on.weights).dot(position - at.on.point) >= 0;
    shape.felt = inFront && (shape.felt || at.distance >= radius * (1 - kOverlap));
  }
}

}  // namespace pleura::haptics
