#include <cmath>

#include <benchmark/benchmark.h>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/coordinate.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_set.h>

namespace {

using namespace pleura;

/// A wavy sheet of n x n points.
std::shared_ptr<IndexedTriangleSet> sheet(int n) {
  auto coordinate = create<Coordinate>();
  auto set = create<IndexedTriangleSet>();
  std::vector<Vec3f> points;
  std::vector<std::int32_t> index;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      points.emplace_back(static_cast<float>(k), static_cast<float>(i), std::sin(static_cast<float>(i + k)));
      const int p = i * n + k;
      if (i + 1 < n && k + 1 < n) index.insert(index.end(), {p, p + 1, p + n, p + n, p + 1, p + n + 1});
    }
  coordinate->point.setValue(std::move(points));
  set->index.setValue(std::move(index));
  set->coord.setValue(coordinate);
  return set;
}

/// An organ that deforms: all points move each tick, smooth normals follow.
void movePoints(benchmark::State& state) {
  const auto set = sheet(static_cast<int>(state.range(0)));
  auto& points = static_cast<Coordinate&>(*set->coord.getValue()).point;
  for (auto _ : state) {
    points.edit([](auto& all) { all[0].z() += 1e-3f; });
    benchmark::DoNotOptimize(set->renderMesh().normals.data());
  }
  state.counters["points"] = static_cast<double>(points.size());
}
BENCHMARK(movePoints)->Arg(55)->Arg(100)->Arg(173)->Unit(benchmark::kMicrosecond);

void buildTopology(benchmark::State& state) {
  const auto set = sheet(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    set->index.touch();
    benchmark::DoNotOptimize(set->renderMesh().normals.data());
  }
}
BENCHMARK(buildTopology)->Arg(55)->Arg(100)->Arg(173)->Unit(benchmark::kMicrosecond);

void readWhatDidNotChange(benchmark::State& state) {
  const auto set = sheet(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(set->renderMesh().normals.data());
}
BENCHMARK(readWhatDidNotChange)->Arg(100);

}  // namespace
