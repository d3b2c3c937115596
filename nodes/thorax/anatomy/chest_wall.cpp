#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include <pleura/nodes/deformable/mesh/nearest_point.h>
#include <pleura/nodes/thorax/anatomy/chest_wall.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

constexpr double kSmoothing = 5e-6;  // stiffness of the interpolation, against the scatter of single ribs
constexpr int kEvery = 2;            // samples of the lines used

double cubed(const Vector3d& v) {
  const double r2 = v.squaredNorm();
  return r2 * std::sqrt(r2);
}

// The inner line moved off the bone, away from the centreline.
template <class Part>
void addInnerLines(const std::vector<Part>& parts, Side side, double clearance,
                   std::vector<Vector3d>& points) {
  for (const Part& part : parts) {
    if (part.side != side) continue;
    for (std::size_t k = 1; k + 1 < part.innerLine.size(); k += kEvery) {
      const Vector3d inner = part.innerLine[k].template cast<double>();
      points.push_back(inner + clearance * (inner - part.centreline[k].template cast<double>()).normalized());
    }
  }
}

// For each stretch of the bone the point nearest to the wall or furthest through it, if it is nearer than the
// clearance.
template <class Part>
void addProtruding(const ChestWall& wall, const std::vector<Part>& parts, Side side, double clearance,
                   std::vector<Vector3d>& points) {
  constexpr double kSlack = 0.0003;  // [m]
  for (const Part& part : parts) {
    if (part.side != side) continue;
    std::vector<double> deepest(part.centreline.size(), clearance - kSlack);
    std::vector<Vector3d> at(part.centreline.size());
    for (const Eigen::Vector3f& point : part.mesh.points) {
      const std::size_t sample = nearestPoint(part.centreline, point);
      const double beyond = wall.beyond(point.cast<double>());
      if (beyond >= deepest[sample]) continue;
      deepest[sample] = beyond;
      at[sample] = point.cast<double>();
    }
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (deepest[k] < clearance - kSlack)
        points.push_back(at[k] + clearance * (wall.centre() - at[k]).normalized());
    }
  }
}

}  // namespace

ChestWall::ChestWall(const std::vector<Rib>& ribs, const std::vector<Cartilage>& cartilages, Side side,
                     double clearance)
    : centre_(sign(side) * 0.063, 0.03, 0.0) {
  std::vector<Vector3d> points;
  addInnerLines(ribs, side, clearance, points);
  addInnerLines(cartilages, side, clearance, points);
  fit(points);
  addProtruding(*this, ribs, side, clearance, points);
  addProtruding(*this, cartilages, side, clearance, points);
  fit(points);
}

// [ K + l I   P ] [w]   [r]
// [ P^T       0 ] [c] = [0],   K_ij = |d_i - d_j|^3,  P_i = (1, d_i)
void ChestWall::fit(const std::vector<Vector3d>& points) {
  const Eigen::Index n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 4, n + 4);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 4);
  directions_.clear();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector3d ray = points[i] - centre_;
    directions_.push_back(ray.normalized());
    right[i] = ray.norm();
    for (Eigen::Index j = 0; j < i; ++j) {
      system(i, j) = system(j, i) = cubed(directions_[i] - directions_[j]);
    }
    system(i, i) = kSmoothing;
    system.row(i).tail<4>() << 1.0, directions_[i].transpose();
    system.col(i).tail<4>() = system.row(i).tail<4>().transpose();
  }
  weights_ = system.partialPivLu().solve(right);
}

double ChestWall::radius(const Vector3d& direction) const {
  const Eigen::Index n = weights_.size() - 4;
  double r = weights_[n] + weights_.tail<3>().dot(direction);
  for (Eigen::Index i = 0; i < n; ++i) r += weights_[i] * cubed(direction - directions_[i]);
  return r;
}

double ChestWall::beyond(const Vector3d& point) const {
  const Vector3d ray = point - centre_;
  const double distance = ray.norm();
  return distance - radius(ray / std::max(distance, 1e-6));
}

}  // namespace pleura
