#include <cmath>

#include <benchmark/benchmark.h>

#include <pleura/nodes/deformable/fem/corotational_solid.h>
#include <pleura/nodes/deformable/fem/linear_solid.h>
#include <pleura/nodes/deformable/fem/neo_hookean_solid.h>
#include <pleura/tests/nodes/deformable/fem/solid_bodies.h>

// The unit cube of n^3 cells of five tetrahedra under its own weight, its face x = 0 driven to and fro: a
// step of 16.7 ms, and what is done before the first.

namespace pleura {
namespace {

constexpr double kStep = 1. / 60;  // [s]

struct Case {
  SolidMesh mesh;
  SolidConstraints constraints;
};

Case caseOf(const benchmark::State& state) {
  Case made{cube(static_cast<int>(state.range(0)), 4), {}};
  made.constraints.fixed = clampedFace(made.mesh);
  return made;
}

// The face turns about x by 0.3 and goes along by 2 cm, once a second.
void drive(const Case& body, int frame, NodeVectors& prescribed) {
  const double phase = std::sin(2 * M_PI * kStep * frame);
  const Eigen::AngleAxisd turn(0.3 * phase, Eigen::Vector3d::UnitX());
  prescribed.clear();
  for (const int i : body.constraints.fixed)
    prescribed.push_back(turn * body.mesh.nodes[static_cast<std::size_t>(i)] +
                         Eigen::Vector3d(0.02 * phase, 0, 0));
}

template <class Solid>
void steps(benchmark::State& state, Solid& solid, const Case& body) {
  const NodeVectors forces = weights(solid.body().mass, {0, 0, -9.81});
  NodeVectors prescribed;
  int frame = 0, count = 0;
  double residual = 0, iterations = 0;
  for (auto _ : state) {
    drive(body, ++frame, prescribed);
    const SolidReport report = solid.step(kStep, {.forces = forces, .prescribed = prescribed});
    residual = std::max(residual, report.residual);
    iterations += report.iterations;
    ++count;
  }
  state.counters["elements"] = solid.body().elements.count();
  state.counters["worst_residual"] = residual;
  state.counters["iterations"] = iterations / count;
}

SolidMaterial material() {
  SolidMaterial made = softCube();
  made.massDamping = 1;
  return made;
}

void linearStep(benchmark::State& state) {
  const Case body = caseOf(state);
  LinearSolid solid(body.mesh, material(), body.constraints);
  solid.step(kStep, {});
  steps(state, solid, body);
}
BENCHMARK(linearStep)->ArgName("cells")->Arg(10)->Arg(16)->Unit(benchmark::kMillisecond);

void linearSetUp(benchmark::State& state) {
  const Case body = caseOf(state);
  for (auto _ : state) {
    LinearSolid solid(body.mesh, material(), body.constraints);
    benchmark::DoNotOptimize(solid.step(kStep, {}));
  }
}
BENCHMARK(linearSetUp)->ArgName("cells")->Arg(10)->Arg(16)->Unit(benchmark::kMillisecond);

void corotationalStep(benchmark::State& state) {
  const Case body = caseOf(state);
  CorotationalOptions options;
  options.iterations = static_cast<int>(state.range(1));
  CorotationalSolid solid(body.mesh, material(), body.constraints, options);
  solid.step(kStep, {});
  steps(state, solid, body);
}
BENCHMARK(corotationalStep)
    ->ArgNames({"cells", "linearisations"})
    ->ArgsProduct({{10, 16}, {1, 30}})
    ->Unit(benchmark::kMillisecond);

void neoHookeanStep(benchmark::State& state) {
  const Case body = caseOf(state);
  NeoHookeanSolid solid(body.mesh, material(), body.constraints);
  steps(state, solid, body);
}
BENCHMARK(neoHookeanStep)->ArgName("cells")->Arg(10)->Arg(16)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pleura
