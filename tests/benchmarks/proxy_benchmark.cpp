#include "../haptics/contact/surfaces.h"
#include <benchmark/benchmark.h>

#include <pleura/haptics/contact/proxy.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;
using surfaces::Touchable;

constexpr double radius = 1e-3;

/// Slices and stacks of spheres of 5,880, 29,700 and 149,400 triangles.
constexpr std::array<std::array<int, 2>, 3> sizes{{{60, 50}, {150, 100}, {300, 250}}};

surfaces::Surface bumpySphere(std::int64_t size) {
  return surfaces::sphere(sizes[size][0], sizes[size][1], surfaces::bumpyRadius);
}

/// Where a device is at each tick that slides 3 mm under the surface at 0.1 m/s, to and fro on a winding way.
std::vector<Vector3d> slidingDevice() {
  constexpr int ticks = 1 << 14;
  std::vector<Vector3d> way;
  for (int i = 0; i < ticks; ++i) {
    const double angle = 1e-4 / 0.047 * std::min(i, ticks - i);
    const Vector3d direction =
        Eigen::AngleAxisd(0.6, Vector3d::UnitY()) *
        Vector3d(std::cos(angle), std::sin(angle), 0.3 * std::sin(3.1 * angle)).normalized();
    way.push_back((surfaces::bumpyRadius(direction) - 0.003) * direction);
  }
  return way;
}

/// Counts ticks; one in which the proxy touches nothing is an error.
class Slide {
 public:
  explicit Slide(const Touchable& touchable) : touchable_(touchable), way_(slidingDevice()) {
    proxy_.reset(way_[0] * 1.2);
    proxy_.follow(std::span(&touchable_.shape, 1), way_[0]);
  }
  void tick() {
    proxy_.follow(std::span(&touchable_.shape, 1), way_[++ticks_ % way_.size()]);
    lost_ += proxy_.contacts().empty() ? 1 : 0;
  }
  std::int64_t ticks() const { return ticks_; }
  void report(benchmark::State& state) const {
    if (lost_ > 0) state.SkipWithError("a tick without contact");
  }

 private:
  const Touchable& touchable_;
  std::vector<Vector3d> way_;
  Proxy proxy_{radius};
  std::int64_t ticks_ = 0, lost_ = 0;
};

void slide(benchmark::State& state, double friction) {
  Touchable sphere(bumpySphere(state.range(0)));
  sphere.shape.surface.staticFriction = friction;
  sphere.shape.surface.dynamicFriction = friction / 2;
  Slide run(sphere);
  for (auto _ : state) run.tick();
  run.report(state);
}

void slideSmooth(benchmark::State& state) { slide(state, 0); }
void slideRough(benchmark::State& state) { slide(state, 0.4); }

/// A surface that swells and shrinks by 1 mm, a frame every 33 ticks; fits are not counted.
void slideDeforming(benchmark::State& state) {
  const surfaces::Surface surface = bumpySphere(state.range(0));
  Touchable sphere(surface);
  std::vector<Eigen::Vector3f> swollen = surface.points;
  for (Eigen::Vector3f& p : swollen) p *= 1.02F;
  sphere.goTo(swollen);
  Slide run(sphere);
  for (auto _ : state) {
    const double phase = static_cast<double>(run.ticks() % 66) / 33;
    sphere.shape.s = static_cast<float>(phase < 1 ? phase : 2 - phase);
    run.tick();
  }
  run.report(state);
}

void fit(benchmark::State& state) {
  const surfaces::Surface surface = bumpySphere(state.range(0));
  Touchable sphere(surface);
  for (auto _ : state) sphere.from.fit(sphere.mesh, surface.points);
}

BENCHMARK(slideSmooth)->DenseRange(0, 2);
BENCHMARK(slideRough)->DenseRange(0, 2);
BENCHMARK(slideDeforming)->DenseRange(0, 2);
BENCHMARK(fit)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pleura::haptics
