#include <algorithm>
#include <cmath>
#include <limits>

#include <pleura/nodes/lung/planar/polygon.h>
#include <pleura/nodes/lung/planar/rounded_wall.h>

namespace pleura::planar {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

RoundedWall::RoundedWall(const ChestOutline& outline) : outline_(outline), points_(outline.rest) {
  move(Vector2d::Zero());
}

void RoundedWall::move(const Vector2d& q) {
  for (std::size_t k = 0; k < points_.size(); ++k) points_[k] = outline_.at(k, q);
  longest_ = 0;
  for (std::size_t k = 0; k < points_.size(); ++k)
    longest_ = std::max(longest_, (points_[next(k)] - points_[k]).norm());
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

WallGap RoundedWall::gapAt(const Vector2d& x, double reach) const {
  std::size_t k = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double squared = (x - points_[i]).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    k = i;
  }
  WallGap found;
  const double far = reach + longest_;
  if (least > far * far) {
    const Vector2d along = points_[next(k)] - points_[before(k)];
    found.gap = std::copysign(std::sqrt(least), outline_.orientation * cross(along, x - points_[k]));
    return found;
  }

  // The foot: (x - c(s)) . c'(s) = 0, by Newton's method, over to the neighbour at either end.
  Piece on = piece(k);
  double s = 0.5;
  Vector2d r, tangent;
  for (int tries = 0, moves = 0; tries < 30; ++tries) {
    r = x - on.start - s * on.slope - s * s / 2 * on.bend;
    tangent = on.slope + s * on.bend;
    const double slope = tangent.squaredNorm() - r.dot(on.bend);
    const double by = r.dot(tangent) / (slope > 0 ? slope : tangent.squaredNorm() + 1e-300);
    const double to = std::clamp(s + by, 0.0, 1.0);
    const bool isDone = std::abs(to - s) <= 1e-15;
    if (isDone && s + by > 1 && moves < 4) {
      k = next(k);
      on = piece(k);
      s = 0;
      ++moves;
    } else if (isDone && s + by < 0 && moves < 4) {
      k = before(k);
      on = piece(k);
      s = 1;
      ++moves;
    } else if (isDone) {
      break;
    } else {
      s = to;
    }
  }
  const double length = tangent.norm();
  if (!(length > 0)) return found;
  const Vector2d t = tangent / length;
  const Vector2d n = outline_.orientation * Vector2d(-t.y(), t.x());
  found.gap = n.dot(r);
  if (!(found.gap < reach)) return found;

  // With dc = c_q dq along the chest's motion and its change along the wall c_q', and the foot eliminated
  // (gap f(z, s): f_zz - f_zs f_zs' / f_ss):
  //   d gap = n . (dx - c_q dq)
  //   d2 gap = m (-kappa T T' + T L' + L T' - gap L L'),  m = 1 / (1 - kappa gap),
  //   T = t . (dx - c_q dq),  L = -n . c_q' dq / |c'|,  kappa = n . c'' / |c'|^2
  const std::array<double, 3> weight{(1 - s) * (1 - s) / 2, 0.5 + s - s * s, s * s / 2};
  const std::array<double, 3> change{s - 1, 1 - 2 * s, s};
  Eigen::Matrix2d by_q = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d by_q_along = Eigen::Matrix2d::Zero();
  for (std::size_t a = 0; a < 3; ++a) {
    Eigen::Matrix2d moved;
    moved << outline_.diaphragm[on.points[a]], outline_.chestWall[on.points[a]];
    by_q += weight[a] * moved;
    by_q_along += change[a] * moved;
  }
  found.isNear = true;
  found.gradient << n, -by_q.transpose() * n;
  Vector4d along;
  along << t, -by_q.transpose() * t;
  Vector4d turn;
  turn << 0, 0, -by_q_along.transpose() * n / length;
  const double kappa = n.dot(on.bend) / (length * length);
  const double m = 1 / (1 - kappa * found.gap);
  const Matrix4d mixed = along * turn.transpose();
  found.curvature = m * (mixed + mixed.transpose() - kappa * along * along.transpose() -
                         found.gap * turn * turn.transpose());
  return found;
}

}  // namespace pleura::planar
