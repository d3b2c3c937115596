#include <cmath>

#include <pleura/nodes/lung/planar/pleural_space.h>
#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector4d;

constexpr double kAnywhere = 1e3;  // [m]

/// b(y) = -(1 - y)^2 ln y: smooth, 0 from y = 1 on, infinite at 0 (Li et al. 2020, Incremental potential
/// contact).
double barrier(double y) { return -(1 - y) * (1 - y) * std::log(y); }

double barrierSlope(double y) { return (1 - y) * (2 * std::log(y) - (1 - y) / y); }

double barrierCurvature(double y) { return -2 * std::log(y) + (1 - y) * (1 + 3 * y) / (y * y); }

}  // namespace

PleuralSpace::PleuralSpace(const ChestOutline& wall, std::span<const Vector2d> lungOutline, Index firstFree,
                           Index freeCount, double thickness, double film, double naturalScale,
                           double contactPressure)
    : wall_(wall),
      rest_(lungOutline.begin(), lungOutline.end()),
      lung_(rest_),
      firstFree_(firstFree),
      freeCount_(freeCount),
      orientation_(wall.orientation),
      thickness_(thickness),
      film_(film),
      contactPressure_(contactPressure),
      volumeGradient_(2 * freeCount) {
  const std::array<std::span<const Vector2d>, 2> modes{wall.diaphragm, wall.chestWall};
  wallArea_ = orientation_ * area(wall.rest);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto a = static_cast<Index>(i);
    wallGradient_[a] = orientation_ * (areaForm(wall.rest, modes[i]) + areaForm(modes[i], wall.rest));
    for (std::size_t j = 0; j < 2; ++j)
      wallCurvature_(a, static_cast<Index>(j)) =
          orientation_ * (areaForm(modes[i], modes[j]) + areaForm(modes[j], modes[i]));
  }
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const std::size_t next = i + 1 < rest_.size() ? i + 1 : 0;
    const std::size_t before = i > 0 ? i - 1 : rest_.size() - 1;
    const double drawn = thickness / naturalScale;  // lengths as the lung lies on the wall
    const double edge = (rest_[next] - rest_[i]).norm() * drawn;
    const double edgeBefore = (rest_[i] - rest_[before]).norm() * drawn;
    if (slotOf(i) >= 0) samples_.push_back({i, 0, (edge + edgeBefore) / 4});
    if (slotOf(i) >= 0 || slotOf(next) >= 0) samples_.push_back({i, 0.5, edge / 2});
  }
  contacts_.reserve(samples_.size());
}

Index PleuralSpace::slotOf(std::size_t point) const {
  const Index free = static_cast<Index>(point) - firstFree_;
  return free >= 0 && free < freeCount_ ? 2 * free : -1;
}

Vector2d PleuralSpace::positionOf(const Sample& sample) const {
  const std::size_t next = sample.edge + 1 < lung_.size() ? sample.edge + 1 : 0;
  return (1 - sample.part) * lung_[sample.edge] + sample.part * lung_[next];
}

bool PleuralSpace::place(const Eigen::VectorXd& displacement, const Vector2d& q) {
  q_ = q;
  wall_.move(q);
  for (Index f = 0; f < freeCount_; ++f) {
    const auto i = static_cast<std::size_t>(firstFree_ + f);
    lung_[i] = rest_[i] + displacement.segment<2>(2 * f);
  }
  lungArea_ = orientation_ * area(lung_);
  volume_ = thickness_ * (wallArea_ + wallGradient_.dot(q) + q.dot(wallCurvature_ * q) / 2 - lungArea_);
  contacts_.clear();
  if (!(volume_ > 0)) return false;
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const WallGap at = wall_.gapAt(positionOf(samples_[s]), film_);
    if (!(at.gap > 0)) return false;
    if (at.isNear) contacts_.push_back({s, at});
  }
  for (Index f = 0; f < freeCount_; ++f)
    volumeGradient_.segment<2>(2 * f) =
        -thickness_ * orientation_ * areaGradient(lung_, static_cast<std::size_t>(firstFree_ + f));
  volumeByChest_ = thickness_ * (wallGradient_ + wallCurvature_ * q);
  return true;
}

double PleuralSpace::energy(const PleuralGas& gas) const {
  double energy =
      gas.isSealed ? gas.ambient * volume_ - gas.amount * std::log(volume_) : -gas.gauge * volume_;
  for (const Contact& c : contacts_)
    energy += samples_[c.sample].weight * contactPressure_ * film_ * barrier(c.at.gap / film_);
  return energy;
}

void PleuralSpace::addForces(const PleuralGas& gas, Eigen::VectorXd& onLung, Vector2d& onChest) const {
  const double gauge = gas.gaugeAt(volume_);
  onLung += gauge * volumeGradient_;
  onChest += gauge * volumeByChest_;
  for (const Contact& c : contacts_) {
    const Sample& sample = samples_[c.sample];
    const double force = -sample.weight * contactPressure_ * barrierSlope(c.at.gap / film_);
    const std::size_t i = sample.edge;
    const Index a = slotOf(i);
    const Index b = slotOf(i + 1 < lung_.size() ? i + 1 : 0);
    if (a >= 0) onLung.segment<2>(a) += force * (1 - sample.part) * c.at.gradient.head<2>();
    if (b >= 0) onLung.segment<2>(b) += force * sample.part * c.at.gradient.head<2>();
    onChest += force * c.at.gradient.tail<2>();
  }
}

void PleuralSpace::addStiffness(const PleuralGas& gas, Eigen::MatrixXd& lung, Eigen::MatrixX2d& lungChest,
                                Matrix2d& chest) const {
  // U'' = -dP/dV grad V grad V' - P V''
  const double stiffness = gas.stiffnessAt(volume_);
  const double gauge = gas.gaugeAt(volume_);
  if (stiffness != 0) {
    for (Index j = 0; j < volumeGradient_.size(); ++j)
      lung.col(j) += (stiffness * volumeGradient_[j]) * volumeGradient_;
    for (Index c = 0; c < 2; ++c) lungChest.col(c) += (stiffness * volumeByChest_[c]) * volumeGradient_;
    chest += stiffness * volumeByChest_ * volumeByChest_.transpose();
  }
  chest -= gauge * thickness_ * wallCurvature_;
  const double half = gauge * thickness_ * orientation_ / 2;  // V'' = -t A'', A'' = +-1/2 between neighbours
  for (Index f = 0; f + 1 < freeCount_; ++f) {
    const Index a = 2 * f;
    const Index b = a + 2;
    lung(a, b + 1) += half;
    lung(b + 1, a) += half;
    lung(a + 1, b) -= half;
    lung(b, a + 1) -= half;
  }
  for (const Contact& c : contacts_) {
    const Sample& sample = samples_[c.sample];
    const double y = c.at.gap / film_;
    const double scale = sample.weight * contactPressure_;
    const Eigen::Matrix4d h =
        scale * (barrierCurvature(y) / film_ * c.at.gradient * c.at.gradient.transpose() +
                 barrierSlope(y) * c.at.curvature());
    const std::size_t i = sample.edge;
    const std::array<Index, 2> slot{slotOf(i), slotOf(i + 1 < lung_.size() ? i + 1 : 0)};
    const std::array<double, 2> part{1 - sample.part, sample.part};
    for (std::size_t a = 0; a < 2; ++a) {
      if (slot[a] < 0 || part[a] == 0) continue;
      for (std::size_t b = 0; b < 2; ++b)
        if (slot[b] >= 0 && part[b] != 0)
          lung.block<2, 2>(slot[a], slot[b]) += part[a] * part[b] * h.topLeftCorner<2, 2>();
      lungChest.middleRows<2>(slot[a]) += part[a] * h.topRightCorner<2, 2>();
    }
    chest += h.bottomRightCorner<2, 2>();
  }
}

Vector2d PleuralSpace::meanAndLargestGap() const {
  double sum = 0;
  double weight = 0;
  double largest = 0;
  for (const Sample& sample : samples_) {
    const double gap = wall_.gapAt(positionOf(sample), kAnywhere).gap;
    sum += sample.weight * gap;
    weight += sample.weight;
    largest = std::fmax(largest, gap);
  }
  return {sum / weight, largest};
}

}  // namespace pleura::planar
