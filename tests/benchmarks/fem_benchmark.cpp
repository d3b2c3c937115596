#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <benchmark/benchmark.h>

#include <pleura/nodes/deformable/fem/corotational_solid.h>
#include <pleura/nodes/deformable/fem/embedding.h>
#include <pleura/nodes/deformable/fem/lattice.h>
#include <pleura/nodes/deformable/fem/linear_solid.h>
#include <pleura/nodes/deformable/fem/neo_hookean_solid.h>
#include <pleura/nodes/deformable/job.h>
#include <pleura/tests/nodes/deformable/fem/solid_bodies.h>
#include <pleura/tests/nodes/deformable/springs/geodesic_sphere.h>

// The unit cube of n^3 cells of five tetrahedra under its own weight, its face x = 0 driven to and fro: a
// step of 16.7 ms, and what is done before the first. Then a frame of two lungs.

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

/// A lung of the thorax: 24 cm high, narrow at its top, hollow below; half of its surface's points driven.
struct Lung {
  Lattice lattice;
  SolidConstraints held;
  NodeVectors rest;  // of the driven points [m]

  /// Of about so many elements, hexahedra or tetrahedra, at this place.
  Lung(int elements, int nodesPerElement, double size, double at) {
    TriangleMesh mesh = geodesicSphere(16, 1);
    for (Eigen::Vector3f& p : mesh.points) {
      const Eigen::Vector3d x = p.cast<double>();
      const double narrow = 1 - 0.35 * x.y(), hollow = 0.5 * std::exp(-2 * (x.x() * x.x() + x.z() * x.z()));
      p = (size * Eigen::Vector3d(0.06 * narrow * x.x(), 0.12 * (x.y() < 0 ? x.y() + hollow : x.y()),
                                  0.08 * narrow * x.z()) +
           Eigen::Vector3d(at, 0, 0))
              .cast<float>();
    }
    lattice =
        makeLattice(mesh, {.elements = nodesPerElement == 8 ? elements : elements / kTetrahedraPerCell});
    const Embedding points = embed(lattice, mesh.points);
    held.soft.stiffness = 100 * tissue().youngsModulus * lattice.report.cellSize;
    for (std::size_t i = 0; i < mesh.points.size(); i += 2) {
      rest.push_back(mesh.points[i].cast<double>());
      for (std::size_t k = 8 * i; k < 8 * (i + 1); ++k) {
        held.soft.node.push_back(points.nodes[k]);
        held.soft.weight.push_back(points.weights[k]);
      }
      held.soft.begin.push_back(static_cast<int>(held.soft.node.size()));
    }
    if (nodesPerElement == 4) lattice.solid = cutIntoTetrahedra(lattice);
  }

  static SolidMaterial tissue() {
    return {.density = 250, .youngsModulus = 2000, .poissonRatio = 0.3, .stiffnessDamping = 0.05};
  }

  /// Breathes in and out in 4 s: the base goes down by 1.5 cm, the sides out by a twentieth.
  void breathe(double time, NodeVectors& targets) const {
    const double depth = 0.5 - 0.5 * std::cos(2 * M_PI * time / 4);
    targets.clear();
    for (const Eigen::Vector3d& p : rest)
      targets.emplace_back(p.x() * (1 + 0.05 * depth), p.y() - 0.015 * depth * (0.12 - p.y()) / 0.24,
                           p.z() * (1 + 0.05 * depth));
  }
};

template <class Solid>
struct BreathingLung {
  Lung lung;
  Solid solid;
  NodeVectors targets;

  template <class... Options>
  explicit BreathingLung(Lung made, const Options&... options)
      : lung(std::move(made)), solid(lung.lattice.solid, Lung::tissue(), lung.held, options...) {
    step(0);
  }

  SolidReport step(double time) {
    lung.breathe(time, targets);
    return solid.step(kLungStep, {.targets = targets});
  }

  static constexpr double kLungStep = 0.016;  // [s]
};

/// A frame of both, the right one of 11,000 elements and the left of 9,000, in one thread or two.
template <class Solid, class... Options>
void bothLungs(benchmark::State& state, const Options&... options) {
  const int kind = static_cast<int>(state.range(0));
  setThreads(static_cast<int>(state.range(1)));
  BreathingLung<Solid> right(Lung(11000, kind, 1, -0.08), options...);
  BreathingLung<Solid> left(Lung(9000, kind, 0.93, 0.08), options...);
  double time = 0, residual = 0;
  SolidReport onTheRight, onTheLeft;
  Job stepRight([&] { onTheRight = right.step(time); });
  Job stepLeft([&] { onTheLeft = left.step(time); });
  for (auto _ : state) {
    time += right.kLungStep;
    for (Job* step : {&stepRight, &stepLeft}) step->offer();
    for (Job* step : {&stepRight, &stepLeft}) step->finish();
    residual = std::max({residual, onTheRight.residual, onTheLeft.residual});
  }
  state.counters["elements"] = right.solid.body().elements.count() + left.solid.body().elements.count();
  state.counters["nodes"] =
      static_cast<double>(right.solid.body().rest.size() + left.solid.body().rest.size());
  state.counters["worst_residual"] = residual;
}

void linearLungs(benchmark::State& state) { bothLungs<LinearSolid>(state); }
BENCHMARK(linearLungs)
    ->ArgNames({"nodes", "threads"})
    ->ArgsProduct({{4, 8}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void corotationalLungs(benchmark::State& state) {
  CorotationalOptions options;
  options.iterations = 1;
  bothLungs<CorotationalSolid>(state, options);
}
BENCHMARK(corotationalLungs)
    ->ArgNames({"nodes", "threads"})
    ->ArgsProduct({{4, 8}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pleura
