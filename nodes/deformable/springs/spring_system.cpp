#include <algorithm>

#include <Eigen/LU>

#include <pleura/nodes/deformable/springs/spring_system.h>

namespace pleura {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLeastShift =
    1e-6;  // keeps blocks invertible: of a point between springs in a line or plane
constexpr double kFarthestStep = 1e20;        // along a search direction: beyond it there is no curvature
constexpr double kSmallestResidual = 1e-200;  // squared: below it quotients mean nothing

// Every point's own 3 x 3 block of the tangent, then its inverse.
void precondition(const SpringModel& model, SpringWorkspace& w, double relativeShift) {
  for (std::size_t i = 0; i < w.inertia.size(); ++i)
    w.preconditioner[i] = w.inertia[i] * Matrix3d::Identity();
  for (int a = 0; a < model.pointCount(); ++a)
    for (int s = model.begin[a]; s < model.begin[a + 1]; ++s) {
      const SpringTangent& t = w.tangent[s];
      Matrix3d block = t.axial * t.n * t.n.transpose();
      block.diagonal().array() += t.lateral;
      w.preconditioner[a] += block;
      w.preconditioner[model.end[s]] += block;
    }
  for (std::size_t i = 0; i < w.inertia.size(); ++i) {
    Matrix3d& block = w.preconditioner[i];
    const double trace = block.trace();
    w.diagonal[i] = w.inertia[i] + relativeShift * trace;
    block.diagonal().array() += std::max(relativeShift, kLeastShift) * trace;
    if (w.isDriven[i] != 0 || trace <= 0)
      block.setZero();
    else
      block = block.inverse().eval();
  }
}

struct Curvature {
  double springs = 0;  // p . (T + diagonal) p
  double volume = 0;   // c . p
};

// product = (T + diagonal) p. Rows go up, so that a row is complete when its own springs are added.
Curvature applyTangent(const SpringModel& model, SpringWorkspace& w) {
  Curvature curvature;
  for (std::size_t i = 0; i < w.search.size(); ++i) w.product[i] = w.diagonal[i] * w.search[i];
  for (int a = 0; a < model.pointCount(); ++a) {
    const Vector3d p = w.search[a];
    Vector3d sum = w.product[a];
    for (int s = model.begin[a]; s < model.begin[a + 1]; ++s) {
      const SpringTangent& t = w.tangent[s];
      const Vector3d d = w.search[model.end[s]] - p;
      const Vector3d f = t.lateral * d + (t.axial * t.n.dot(d)) * t.n;
      sum -= f;
      w.product[model.end[s]] += f;
    }
    w.product[a] = sum;
    curvature.springs += p.dot(sum);
    curvature.volume += p.dot(w.volumeGradient[a]);
  }
  return curvature;
}

// (B + slope c c^T)^-1 r = B^-1 r - share (c . B^-1 r) B^-1 c,  share = slope / (1 + slope c . B^-1 c)
struct Preconditioned {
  double blocks = 0;  // r . B^-1 r
  double volume = 0;  // c . B^-1 r
  double of(double share) const { return blocks - share * volume * volume; }
};

double preconditionVolume(SpringWorkspace& w, double slope) {
  if (slope <= 0) {
    std::fill(w.preconditionedVolume.begin(), w.preconditionedVolume.end(), Vector3d::Zero());
    return 0;
  }
  double sum = 0;
  for (std::size_t i = 0; i < w.volumeGradient.size(); ++i) {
    w.preconditionedVolume[i] = w.preconditioner[i] * w.volumeGradient[i];
    sum += w.volumeGradient[i].dot(w.preconditionedVolume[i]);
  }
  return slope / (1 + slope * sum);
}

// direction += alpha search;  residual -= alpha (product + volume c);  preconditioned = B^-1 residual
Preconditioned advance(SpringWorkspace& w, double alpha, double volume) {
  Preconditioned sums;
  for (std::size_t i = 0; i < w.residual.size(); ++i) {
    w.direction[i] += alpha * w.search[i];
    const Vector3d r = w.residual[i] - alpha * (w.product[i] + volume * w.volumeGradient[i]);
    const Vector3d z = w.preconditioner[i] * r;
    w.residual[i] = r;
    w.preconditioned[i] = z;
    sums.blocks += r.dot(z);
    sums.volume += r.dot(w.preconditionedVolume[i]);
  }
  return sums;
}

// search = preconditioned - volume B^-1 c + beta search
void turn(SpringWorkspace& w, double volume, double beta) {
  for (std::size_t i = 0; i < w.search.size(); ++i)
    w.search[i] = w.preconditioned[i] - volume * w.preconditionedVolume[i] + beta * w.search[i];
}

}  // namespace

int solveSpringSystem(const SpringModel& model, SpringWorkspace& w, double slope, double relativeShift,
                      double tolerance, int maxIterations) {
  precondition(model, w, relativeShift);
  const double share = preconditionVolume(w, slope);
  for (std::size_t i = 0; i < w.residual.size(); ++i) {
    w.residual[i] = -w.gradient[i];
    w.direction[i].setZero();
    w.search[i].setZero();
    w.product[i].setZero();
  }
  Preconditioned sums = advance(w, 0, 0);
  turn(w, share * sums.volume, 0);
  double rz = sums.of(share);
  const double end = tolerance * tolerance * rz;
  int iteration = 0;
  while (iteration < maxIterations && rz > end && rz > kSmallestResidual) {
    const Curvature curvature = applyTangent(model, w);
    const double pq = curvature.springs + slope * curvature.volume * curvature.volume;
    if (pq * kFarthestStep <= rz) break;
    sums = advance(w, rz / pq, slope * curvature.volume);
    const double next = sums.of(share);
    turn(w, share * sums.volume, next / rz);
    rz = next;
    ++iteration;
  }
  return iteration;
}

}  // namespace pleura
