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

double bumps(const Vector3d& d) {
  return 0.05 + 0.001 * std::sin(9 * d.x()) * std::cos(11 * d.y()) * std::sin(7 * d.z() + 1);
}

surfaces::Surface bumpySphere(std::int64_t size) {
  return surfaces::sphere(sizes[size][0], sizes[size][1], bumps);
}

/// Where a device is at a tick that slides 3 mm under the surface at 0.1 m/s, round and round a tilted
/// circle.
Vector3d sliding(std::int64_t tick) {
  const double angle = 1e-4 * static_cast<double>(tick) / 0.047;
  const Vector3d direction = Eigen::AngleAxisd(0.6, Vector3d::UnitY()) *
                             Vector3d(std::cos(angle), std::sin(angle), 0.3 * std::sin(3.1 * angle));
  return (bumps(direction.normalized()) - 0.003) * direction.normalized();
}

void slide(benchmark::State& state, double friction) {
  Touchable sphere(bumpySphere(state.range(0)));
  sphere.shape.surface.staticFriction = friction;
  sphere.shape.surface.dynamicFriction = friction / 2;
  Proxy proxy(radius);
  proxy.reset(sliding(0) * 1.2);
  std::int64_t tick = 0, touching = 0;
  for (auto _ : state) {
    proxy.follow(std::span(&sphere.shape, 1), sliding(tick++));
    touching += proxy.contacts().empty() ? 0 : 1;
  }
  state.counters["touching"] = static_cast<double>(touching) / static_cast<double>(tick);
}

void slideSmooth(benchmark::State& state) { slide(state, 0); }
void slideRough(benchmark::State& state) { slide(state, 0.4); }

/// A surface that swells and shrinks by 1 mm, a frame every 33 ticks; refits are not counted.
void slideDeforming(benchmark::State& state) {
  const surfaces::Surface surface = bumpySphere(state.range(0));
  Touchable sphere(surface);
  std::vector<Eigen::Vector3f> swollen = surface.points;
  for (Eigen::Vector3f& p : swollen) p *= 1.02F;
  sphere.goTo(swollen);
  Proxy proxy(radius);
  proxy.reset(sliding(0) * 1.2);
  std::int64_t tick = 0, touching = 0;
  for (auto _ : state) {
    const double phase = static_cast<double>(tick % 66) / 33;
    sphere.shape.s = static_cast<float>(phase < 1 ? phase : 2 - phase);
    proxy.follow(std::span(&sphere.shape, 1), sliding(tick++));
    touching += proxy.contacts().empty() ? 0 : 1;
  }
  state.counters["touching"] = static_cast<double>(touching) / static_cast<double>(tick);
}

void sine(benchmark::State& state) {
  std::int64_t tick = 0;
  for (auto _ : state) benchmark::DoNotOptimize(sliding(tick++));
}

void fit(benchmark::State& state) {
  const surfaces::Surface surface = bumpySphere(state.range(0));
  Touchable sphere(surface);
  for (auto _ : state) sphere.from.fit(sphere.mesh, surface.points);
}

BENCHMARK(sine);
BENCHMARK(slideSmooth)->DenseRange(0, 2);
BENCHMARK(slideRough)->DenseRange(0, 2);
BENCHMARK(slideDeforming)->DenseRange(0, 2);
BENCHMARK(fit)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pleura::haptics
