#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/springs/spring_energy.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

// dE = f n . (dx_b - dx_a) with f = k (L - l), L n = x_b - x_a;  d2E = f/L (1 - n n^T) + k n n^T.
double evaluateEdges(const SpringModel& model, SpringWorkspace& w) {
  double energy = 0;
  for (int a = 0; a < model.pointCount(); ++a) {
    const Vector3d xa = w.trial[a];
    Vector3d sum = Vector3d::Zero();
    for (int s = model.begin[a]; s < model.begin[a + 1]; ++s) {
      const int b = model.end[s];
      const double k = w.stiffness[s], rest = w.length[s];
      const Vector3d d = w.trial[b] - xa;
      const double length = d.norm();
      const double over = length > 0 ? 1 / length : 0;
      const Vector3d n = over * d;
      const double f = k * (length - rest);
      const double lateral = length > rest ? f * over : 0;
      energy += f * (length - rest) / 2;
      w.tangent[s] = {n, k - lateral, length > 0 ? lateral : k};
      sum += f * n;
      w.gradient[b] += f * n;
    }
    w.gradient[a] -= sum;
  }
  return energy;
}

// V = sum (a - o) . S / 3 with S the area of a triangle times its normal; on a closed surface dV/da = sum
// S/3.
double evaluateVolume(const SpringModel& model, SpringWorkspace& w) {
  if (model.triangles.empty()) return 0;
  std::fill(w.volumeGradient.begin(), w.volumeGradient.end(), Vector3d::Zero());
  const Vector3d o = w.trial[model.triangles[0][0]];
  double volume = 0;
  for (const Eigen::Vector3i& t : model.triangles) {
    const Vector3d a = w.trial[t[0]];
    const Vector3d third = (w.trial[t[1]] - a).cross(w.trial[t[2]] - a) / 6;
    volume += (a - o).dot(third);
    for (const int corner : t) w.volumeGradient[corner] += third;
  }
  return volume;
}

double evaluateInertia(SpringWorkspace& w) {
  double energy = 0;
  for (std::size_t i = 0; i < w.trial.size(); ++i) {
    const Vector3d force = w.inertia[i] * (w.trial[i] - w.predicted[i]);
    energy += force.dot(w.trial[i] - w.predicted[i]) / 2;
    w.gradient[i] += force;
  }
  return energy;
}

}  // namespace

void prepareForRest(const SpringModel& model, SpringWorkspace& w) {
  w.stiffness = model.stiffness;
  w.length = model.length;
  std::fill(w.inertia.begin(), w.inertia.end(), 0.0);
  w.hold = {0, model.holdModulus};
}

void prepareForStep(const SpringModel& model, SpringWorkspace& w, std::span<const Vector3d> positions,
                    std::span<const Vector3d> velocities, double step) {
  // k/2 (L - l)^2 + c/(2 step) (L - L_0)^2 with c = k relaxationTime, as one spring
  const double damper = model.relaxationTime / step;
  for (int a = 0; a < model.pointCount(); ++a)
    for (int s = model.begin[a]; s < model.begin[a + 1]; ++s) {
      const double before = (positions[model.end[s]] - positions[a]).norm();
      w.stiffness[s] = model.stiffness[s] * (1 + damper);
      w.length[s] = (model.length[s] + damper * before) / (1 + damper);
    }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    w.inertia[i] = model.mass[i] / (step * step);
    w.predicted[i] = positions[i] + step * velocities[i];
  }
  w.hold = {0, model.holdModulus};
}

double storedEnergy(const SpringModel& model, SpringWorkspace& w, std::span<const Vector3d> positions) {
  prepareForRest(model, w);
  w.hold = {};
  std::copy(positions.begin(), positions.end(), w.trial.begin());
  return evaluateSprings(model, w).energy;
}

SpringEnergy evaluateSprings(const SpringModel& model, SpringWorkspace& w) {
  SpringEnergy result;
  std::fill(w.gradient.begin(), w.gradient.end(), Vector3d::Zero());
  const double elastic = evaluateEdges(model, w) + evaluateInertia(w);
  result.volume = evaluateVolume(model, w);
  result.interior = interiorAt(model.interior, w.hold, result.volume, model.restVolume);
  result.energy = elastic + result.interior.energy;
  result.magnitude = elastic + std::abs(result.interior.energy);
  double squares = 0;
  for (std::size_t i = 0; i < w.gradient.size(); ++i) {
    w.gradient[i] -= result.interior.pressure * w.volumeGradient[i];
    if (w.isDriven[i] != 0) {
      w.gradient[i].setZero();
      w.volumeGradient[i].setZero();
    }
    squares += w.gradient[i].squaredNorm();
  }
  result.unbalanced = std::sqrt(squares);
  return result;
}

}  // namespace pleura
