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

/// The share of what is gathered on top that lies ahead, the way the ball went since the last time.
constexpr double kLead = 0.8;

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
  ++changes_;
}

void Neighbourhood::expect(int triangle) {
  Shape& shape = shapes_[triangles_[triangle].shape];
  shape.likely = triangle;
  shape.likelyIndex = triangles_[triangle].index;
}

int Neighbourhood::find(std::uint32_t id) const {
  for (int k = 0; k < shapeCount_; ++k)
    if (shapes_[k].now.id == id) return k;
  return -1;
}

/// Sets triangle count_, but for its shape.
void Neighbourhood::add(const TouchShape& shape, int index) {
  const Corners corners = cornersOf(shape, index);
  Triangle& triangle = triangles_[count_];
  triangle.corners = corners;
  triangle.index = index;
  fours_[count_ / 4].set(count_ % 4, corners.colwise() - centre_);
}

Neighbourhood::Nearest Neighbourhood::nearest(const Shape& shape, const Vector3d& point,
                                              double within) const {
  Nearest least;
  least.distance = within;
  const auto look = [&](int i) {
    const TrianglePoint on = nearestOnTriangle(triangles_[i].corners, point);
    const double distance = (point - on.point).norm();
    if (distance < least.distance) least = {i, on, distance};
  };
  if (shape.likely >= 0) look(shape.likely);
  visitWithin(shape, point, least.distance, look);
  return least;
}

/// The ball's way with the triangle that is nearest to it.
void Neighbourhood::carry(Shape& shape, const TouchShape& next, const Vector3d& position) const {
  shape.view = position;
  shape.motion.setZero();
  const Nearest at = nearest(shape, position, reachOf(shape));
  if (at.triangle < 0) return;
  const Corners& before = triangles_[at.triangle].corners;
  const Corners after = cornersOf(next, triangles_[at.triangle].index);
  if (before == after) return;
  const Vector3d offset = position - at.on.point;
  Matrix3d frameBefore, frameAfter;
  const bool turns = frameOf(before, frameBefore) && frameOf(after, frameAfter);
  const Vector3d point = after * at.on.weights;
  shape.motion = point - at.on.point;
  shape.view = point + (turns ? Vector3d(frameAfter * (frameBefore.transpose() * offset)) : offset);
}

void Neighbourhood::advance(std::span<const TouchShape> shapes, const Vector3d& position) {
  int kept = 0;
  moving_ = false;
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
      moving_ = true;
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
    if (find(shape.id) < 0) visitNear(shape, centre_, reach_, [&](int) { return valid_ = false; });
}

/// Whether the ball feels a shape that has appeared, as soon as the nearest triangle is surely here: nearer
/// than reach.
void Neighbourhood::judge(Shape& shape, double radius, double reach) {
  const Nearest at = nearest(shape, shape.view, reach);
  shape.isJudged = at.triangle >= 0;
  shape.felt = shape.isJudged && isInFront(shape, at, shape.view) && at.distance >= radius * (1 - kOverlap);
}

/// Gathers about the place that is `lead` from the ball's. False if there is no room for all triangles,
/// unless a part will do.
bool Neighbourhood::collect(std::span<const TouchShape> shapes, const Vector3d& position, double radius,
                            double reach, bool partly, const Vector3d& lead) {
  count_ = 0;
  centre_ = position + lead;
  reach_ = reach;
  bool complete = true;
  const int known = shapeCount_;
  for (int k = 0; k < known; ++k) {
    shapes_[k].begin = shapes_[k].end = 0;
    shapes_[k].likely = -1;
  }
  ++changes_;
  for (const TouchShape& touchable : shapes) {
    int k = find(touchable.id);
    const bool isNew = k < 0;
    if (isNew) k = shapeCount_;
    const int first = count_;
    const Vector3d view = isNew ? position : shapes_[k].view;
    const double distance = reach + (view - position).norm();
    const Vector3d centre = view + lead;
    visitNear(touchable, centre, distance, [&](int index) {
      if (count_ == kMaxTriangles || k == kMaxShapes) return complete = false;
      if (k < known && index == shapes_[k].likelyIndex) shapes_[k].likely = count_;
      add(touchable, index);
      triangles_[count_++].shape = k;
      return true;
    });
    if (isNew && count_ == first) continue;
    Shape& shape = shapes_[k];
    if (isNew) {
      shape = Shape{};
      shape.now = touchable;
      shape.mesh = touchable.mesh->serial();
      shape.from = touchable.from->serial;
      shape.to = touchable.to->serial;
      shape.view = position;
      ++shapeCount_;
    }
    shape.begin = first;
    shape.end = count_;
  }
  if (!complete && !partly) {
    shapeCount_ = known;
    return false;
  }
  for (int four = 0; four * 4 < count_; ++four) fours_[four].bound();
  int kept = 0;
  for (int k = 0; k < shapeCount_; ++k) {
    if (shapes_[k].begin == shapes_[k].end) continue;
    for (int i = shapes_[k].begin; i < shapes_[k].end; ++i) triangles_[i].shape = kept;
    shapes_[kept++] = shapes_[k];
  }
  shapeCount_ = kept;
  for (int k = 0; k < shapeCount_; ++k)
    if (!shapes_[k].isJudged)
      judge(shapes_[k], radius, reach + (shapes_[k].view - position).norm() - lead.norm());
  return true;
}

double Neighbourhood::gather(std::span<const TouchShape> shapes, const Vector3d& position, double radius,
                             double always, double reach) {
  if (valid_ && (position - centre_).norm() + reach <= reach_) return reach;
  // the next ticks find theirs here too, unless the shapes move on
  const double slack = moving_ ? radius / 2 : radius;
  Vector3d lead = Vector3d::Zero();  // none on a long way, of which all that is gathered is needed
  if (valid_ && reach <= always) lead = kLead * slack * (position - centre_).normalized();
  double room = std::min(reach, always) + slack;
  for (int k = 0; !collect(shapes, position, radius, room, k == kMaxHalvings, lead); ++k) {
    room = radius + (room - radius) / 2;
    lead.setZero();
  }
  while (count_ < kFew && room < reach + slack) {
    const double wider = std::min(2 * room, reach + slack);
    if (!collect(shapes, position, radius, wider, false, lead)) {
      collect(shapes, position, radius, room, true, lead);
      break;
    }
    room = wider;
  }
  valid_ = true;
  return std::min(reach, room);
}

void Neighbourhood::moveTo(const Vector3d& position) {
  for (int k = 0; k < shapeCount_; ++k) shapes_[k].view = position;
}

void Neighbourhood::settle(const Vector3d& position, double radius) {
  for (int k = 0; k < shapeCount_; ++k) {
    Shape& shape = shapes_[k];
    if (shape.felt && (shape.now.surface.twoSided || shape.now.mesh->isClosed())) continue;
    const Nearest at = nearest(shape, position, reachOf(shape));
    if (at.triangle < 0) continue;
    const bool felt =
        isInFront(shape, at, position) && (shape.felt || at.distance >= radius * (1 - kOverlap));
    if (felt != shape.felt) ++changes_;
    shape.felt = felt;
  }
}

bool Neighbourhood::isInFront(const Shape& shape, const Nearest& at, const Vector3d& point) const {
  return shape.now.surface.twoSided ||
         outward(shape.now, triangles_[at.triangle].index, at.on.weights).dot(point - at.on.point) >= 0;
}

}  // namespace pleura::haptics
