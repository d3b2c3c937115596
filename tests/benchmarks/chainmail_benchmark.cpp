#include "published_chainmail.h"
#include <benchmark/benchmark.h>

#include <pleura/tests/nodes/deformable/chainmail/organ.h>

// The case in which the faults of the published code were measured: a ball of 10,242 points and radius 12,
// its limits the node's defaults, up to five points moved outwards by 2. (At this radius the published code
// moves the neighbours of a contact by 1.78, 0.89 and 0.45 for 2, 3 and 5 of them.) Lengths are centimetres,
// as in its scenes.

namespace pleura {
namespace {

constexpr float kRadius = 12;

struct Pull {
  std::vector<int> driven;
  Points targets;
};

Pull pullOutwards(const TriangleMesh& mesh, int count, float by) {
  Pull pull{{0, 1, 3, 5, 8}, {}};
  pull.driven.resize(count);
  for (const int i : pull.driven) pull.targets.push_back(mesh.points[i] + by * mesh.points[i].normalized());
  return pull;
}

void measure(benchmark::State& state, Organ& organ, const Pull& pull, const ChainmailOptions& options = {}) {
  ChainmailReport report;
  for (auto _ : state) report = organ.pull(pull.driven, pull.targets, options);
  state.counters["moved"] = report.movedPoints;
  state.counters["visits"] = report.visits;
  state.counters["violated"] = report.violatedLinks;
  state.counters["per_moved"] =
      benchmark::Counter(std::max(1, report.movedPoints),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void ours(benchmark::State& state) {
  Organ organ(icosphere(5, kRadius));
  measure(state, organ, pullOutwards(organ.mesh, static_cast<int>(state.range(0)), 2));
}
BENCHMARK(ours)->ArgName("driven")->Arg(2)->Arg(3)->Arg(5)->Unit(benchmark::kMicrosecond);

void published(benchmark::State& state) {
  Organ organ(icosphere(5, kRadius));
  const Pull pull = pullOutwards(organ.mesh, static_cast<int>(state.range(0)), 2);
  PublishedChainmail chainmail(organ.mesh.points, linkTriangles(organ.mesh.points, organ.mesh.triangles), {});
  for (auto _ : state) {
    organ.positions = organ.mesh.points;
    chainmail.solve(pull.driven, pull.targets, organ.positions);
  }
  state.counters["violated"] = violations(organ, organ.positions, 1e-5).count;
}
BENCHMARK(published)->ArgName("driven")->Arg(2)->Arg(3)->Arg(5)->Unit(benchmark::kMicrosecond);

void oursTurned(benchmark::State& state) {
  Organ organ(icosphere(5, kRadius));
  Pull pull = pullOutwards(organ.mesh, 5, 2);
  ChainmailOptions options;
  options.frame.linear() = Eigen::AngleAxisd(1, Eigen::Vector3d::UnitY()).matrix();
  for (Eigen::Vector3f& target : pull.targets) target = (options.frame * target.cast<double>()).cast<float>();
  measure(state, organ, pull, options);
}
BENCHMARK(oursTurned)->Unit(benchmark::kMicrosecond);

void oursSmoothed(benchmark::State& state) {
  Organ organ(icosphere(5, kRadius));
  ChainmailOptions options;
  options.smoothingSweeps = static_cast<int>(state.range(0));
  measure(state, organ, pullOutwards(organ.mesh, 5, 2), options);
}
BENCHMARK(oursSmoothed)->ArgName("sweeps")->Arg(1)->Arg(4)->Unit(benchmark::kMicrosecond);

// Two points torn farther apart than the ball can stretch: the search overlaps itself.
void oursContradicted(benchmark::State& state) {
  Organ organ(icosphere(5, kRadius), {kDiaphragm});
  measure(state, organ, pullOutwards(organ.mesh, 5, 4));
}
BENCHMARK(oursContradicted)->Unit(benchmark::kMicrosecond);

// Cost against the number of points moved, from a touch to the whole ball.
void costOfMotion(benchmark::State& state) {
  Organ organ(icosphere(5, kRadius));
  Points targets{organ.mesh.points[0] + Eigen::Vector3f(0, 0.25f * static_cast<float>(state.range(0)), 0)};
  measure(state, organ, {{0}, targets});
}
BENCHMARK(costOfMotion)
    ->ArgName("quarters")
    ->RangeMultiplier(2)
    ->Range(1, 128)
    ->Unit(benchmark::kMicrosecond);

// Cost against the size of the mesh, all of it moved: a rigid ball.
void costOfSize(benchmark::State& state) {
  Organ organ(icosphere(static_cast<int>(state.range(0)), kRadius), {kRigid});
  measure(state, organ, pullOutwards(organ.mesh, 1, 2));
}
BENCHMARK(costOfSize)->ArgName("subdivisions")->DenseRange(3, 7)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pleura
