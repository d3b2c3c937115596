#include <algorithm>
#include <cmath>
#include <limits>

#include <pleura/nodes/lung/planar/polygon.h>
#include <pleura/nodes/lung/planar/rounded_wall.h>

namespace pleura::planar {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

namespace {

constexpr double kFoot = 1e-13;   // of a piece
constexpr double kTiny = 1e-300;  // [m^2] keeps a piece without length from dividing by zero
constexpr std::size_t kRun = 8;   // points
constexpr int kMoves = 4;         // to neighbouring pieces

}  // namespace

RoundedWall::RoundedWall(const ChestOutline& outline) : outline_(outline), points_(outline.rest) {
  for (std::size_t begin = 0; begin < points_.size(); begin += kRun)
    runs_.push_back({begin, std::min(begin + kRun, points_.size()), Vector2d::Zero(), 0});
  move(Vector2d::Zero());
}

void RoundedWall::move(const Vector2d& q) {
  for (std::size_t k = 0; k < points_.size(); ++k) points_[k] = outline_.at(k, q);
  double longest = 0;
  for (std::size_t k = 0; k < points_.size(); ++k)
    longest = std::max(longest, (points_[next(k)] - points_[k]).squaredNorm());
  longest_ = std::sqrt(longest);
  for (Run& run : runs_) {
    run.middle = points_[(run.begin + run.end) / 2];
    double radius = 0;
    for (std::size_t k = run.begin; k < run.end; ++k)
      radius = std::max(radius, (points_[k] - run.middle).squaredNorm());
    run.radius = std::sqrt(radius);
  }
}

std::size_t RoundedWall::nearest(const Vector2d& x) const {
  double bound = std::numeric_limits<double>::infinity();
  for (const Run& run : runs_) bound = std::min(bound, (x - run.middle).squaredNorm());
  bound = std::sqrt(bound);
  std::size_t found = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Run& run : runs_) {
    const double reach = bound + run.radius;
    if ((x - run.middle).squaredNorm() > reach * reach) continue;
    for (std::size_t k = run.begin; k < run.end; ++k) {
      const double squared = (x - points_[k]).squaredNorm();
      if (squared >= least) continue;
      least = squared;
      found = k;
    }
  }
  return found;
}

RoundedWall::Piece RoundedWall::piece(std::size_t k) const {
  // c(s) = (1 - s)^2 / 2 w_k-1 + (1/2 + s - s^2) w_k + s^2 / 2 w_k+1
  const std::size_t i = before(k);
  const std::size_t j = next(k);
  return {{i, k, j},
          (points_[i] + points_[k]) / 2,
          points_[k] - points_[i],
          points_[i] - 2 * points_[k] + points_[j]};
}

Matrix4d WallGap::curvature() const {
  // With dc = c_q dq along the chest's motion and its change along the wall c_q', and the foot eliminated
  // (gap f(z, s): f_zz - f_zs f_zs' / f_ss):
  //   d gap = n . (dx - c_q dq)
  //   d2 gap = m (-bend T T' + T L' + L T' - gap L L'),  m = 1 / (1 - bend gap),
  //   T = t . (dx - c_q dq),  L = -n . c_q' dq / |c'|,  bend = n . c'' / |c'|^2
  const double m = 1 / (1 - bend * gap);
  const Vector4d mixed = turn - bend / 2 * along;
  return (m * along) * mixed.transpose() + (m * mixed) * along.transpose() -
         (m * gap * turn) * turn.transpose();
}

WallGap RoundedWall::gapAt(const Vector2d& x, double reach) const {
  std::size_t k = nearest(x);
  const double least = (x - points_[k]).squaredNorm();
  WallGap found;
  const double far = reach + longest_;
  if (least > far * far) {
    const Vector2d along = points_[next(k)] - points_[before(k)];
    found.gap = std::copysign(std::sqrt(least), outline_.orientation * cross(along, x - points_[k]));
    return found;
  }

  // The foot: (x - c(s)) . c'(s) = 0, by Newton's method from the chord's, over to the neighbour at either
  // end.
  Piece on = piece(k);
  const Vector2d chord = on.slope + on.bend / 2;
  double s = std::clamp((x - on.start).dot(chord) / (chord.squaredNorm() + kTiny), 0.0, 1.0);
  Vector2d r;
  Vector2d tangent;
  for (int tries = 0, moves = 0; tries < 30; ++tries) {
    r = x - on.start - s * on.slope - s * s / 2 * on.bend;
    tangent = on.slope + s * on.bend;
    const double slope = tangent.squaredNorm() - r.dot(on.bend);
    const double to = s + r.dot(tangent) / (slope > 0 ? slope : tangent.squaredNorm() + kTiny);
    const double within = std::clamp(to, 0.0, 1.0);
    if (std::abs(within - s) > kFoot) {
      s = within;
    } else if (within == to || moves == kMoves) {
      break;
    } else {
      k = to > 1 ? next(k) : before(k);
      s = to > 1 ? 0 : 1;
      on = piece(k);
      ++moves;
    }
  }
  const double length = tangent.norm();
  if (!(length > 0)) return found;
  const Vector2d t = tangent / length;
  const Vector2d n = outline_.orientation * Vector2d(-t.y(), t.x());
  found.gap = n.dot(r);
  if (!(found.gap < reach)) return found;

  const std::array<double, 3> weight{(1 - s) * (1 - s) / 2, 0.5 + s - s * s, s * s / 2};
  const std::array<double, 3> change{s - 1, 1 - 2 * s, s};
  const auto sum = [&](const std::vector<Vector2d>& mode, const std::array<double, 3>& factor) -> Vector2d {
    return factor[0] * mode[on.points[0]] + factor[1] * mode[on.points[1]] + factor[2] * mode[on.points[2]];
  };
  const Vector2d down = sum(outline_.diaphragm, weight);
  const Vector2d out = sum(outline_.chestWall, weight);
  found.isNear = true;
  found.gradient = Vector4d(n.x(), n.y(), -n.dot(down), -n.dot(out));
  found.along = Vector4d(t.x(), t.y(), -t.dot(down), -t.dot(out));
  found.turn = Vector4d(0, 0, -n.dot(sum(outline_.diaphragm, change)) / length,
                        -n.dot(sum(outline_.chestWall, change)) / length);
  found.bend = n.dot(on.bend) / (length * length);
  return found;
}

}  // namespace pleura::planar
