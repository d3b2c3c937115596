#include <cmath>
#include <numbers>

#include <benchmark/benchmark.h>

#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/deformable/springs/spring_stiffness.h>
#include <pleura/tests/nodes/deformable/springs/elastic_surface.h>

// Each solve begins from rest. A surface that is shortened folds, and folds take Newton's method many
// iterations: the organs are measured with what is inside them, and "residual" says how far each came.

namespace pleura {
namespace {

void count(benchmark::State& state, const ElasticSurface& surface, const SpringReport& report) {
  state.counters["points"] = surface.model.pointCount();
  state.counters["converged"] = report.converged ? 1 : 0;
  state.counters["newton"] = report.iterations;
  state.counters["cg"] = report.linearIterations;
  state.counters["residual"] = report.residual;
}

// Unit sphere, k = 1e4 N/m an edge, n R T = 100 J, no pressure outside; closed form V / V0 - 1 = 0.00207.
void gasInASphere(benchmark::State& state) {
  ElasticSurface surface = balloon(static_cast<int>(state.range(0)));
  SpringReport report;
  for (auto _ : state) report = surface.solve();
  count(state, surface, report);
  state.counters["dV/V"] = report.volume / surface.model.restVolume - 1;
}
BENCHMARK(gasInASphere)->ArgName("cuts")->Arg(8)->Arg(16)->Arg(32)->Unit(benchmark::kMillisecond);

/// About a lung: 24 cm high, narrow at its top, hollow below; a membrane of 200 N/m.
struct Lung {
  ElasticSurface surface;
  std::vector<int> driven;
  Points rest;

  Lung(int cuts, const SpringInterior& interior) : surface(make(cuts, interior)) {
    for (int i = 0; i < surface.model.pointCount(); i += 20) {
      driven.push_back(i);
      rest.push_back(surface.model.rest[i]);
    }
  }

  static ElasticSurface make(int cuts, const SpringInterior& interior) {
    TriangleMesh mesh = geodesicSphere(cuts, 1);
    for (Eigen::Vector3f& p : mesh.points) {
      const float narrow = 1 - 0.35f * p.y(), hollow = 0.5f * std::exp(-2 * (p.x() * p.x() + p.z() * p.z()));
      p = {0.06f * narrow * p.x(), 0.12f * (p.y() < 0 ? p.y() + hollow : p.y()), 0.08f * narrow * p.z()};
    }
    const auto pairs = edges(mesh.points.size(), mesh.triangles);
    return ElasticSurface(mesh, {membraneStiffness(mesh.points, mesh.triangles, pairs, 200), {1e-4}, 0.01},
                          interior);
  }

  /// A breath of this depth: the base goes down by 1.5 cm, the sides out by a twentieth.
  Points targets(double depth) const {
    Points result;
    for (const Eigen::Vector3d& p : rest)
      result.emplace_back(p.x() * (1 + 0.05 * depth), p.y() - 0.015 * depth * (0.12 - p.y()) / 0.24,
                          p.z() * (1 + 0.05 * depth));
    return result;
  }
};

const SpringInterior kInteriors[]{EmptyInterior(), PressureInterior{500}, GasInterior{270, 101325},
                                  VolumeInterior()};

// Arguments: cuts, (17: 2,892 points, 32: 10,242), interior (0 empty, 1 pressure of 5 cmH2O, 2 gas, 3
// volume).
void organFromRest(benchmark::State& state) {
  Lung lung(static_cast<int>(state.range(0)), kInteriors[state.range(1)]);
  const Points targets = lung.targets(1);
  SpringReport report;
  for (auto _ : state) report = lung.surface.solve(lung.driven, targets);
  count(state, lung.surface, report);
}
BENCHMARK(organFromRest)
    ->ArgNames({"cuts", "interior"})
    ->ArgsProduct({{17, 32}, {0, 1, 2, 3}})
    ->Unit(benchmark::kMillisecond);

void organStep(benchmark::State& state) {
  Lung lung(static_cast<int>(state.range(0)), kInteriors[state.range(1)]);
  SpringReport report;
  double time = 0;
  for (auto _ : state) {
    time += 1.0 / 30;
    const double depth = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * time / 4);
    report = lung.surface.step(1.0 / 30, lung.driven, lung.targets(depth));
  }
  count(state, lung.surface, report);
}
BENCHMARK(organStep)
    ->ArgNames({"cuts", "interior"})
    ->ArgsProduct({{17, 32}, {0, 1, 2, 3}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pleura
