#include "../nodes/deformable/mesh/shapes.h"
#include <benchmark/benchmark.h>

#include <pleura/nodes/deformable/mesh/surface_query.h>

namespace pleura {
namespace {

/// A torus of 2 n^2 triangles, and points near its surface, as a lung's are near the ribs.
struct Case {
  explicit Case(int n) : mesh(shapes::torus(n, n)), surface(mesh.points, mesh.triangles) {
    std::mt19937 random(1);
    for (int i = 0; i < 4096; ++i) {
      const Eigen::Vector3d on = mesh.points[random() % mesh.points.size()].cast<double>();
      asked.push_back(on + shapes::randomPoint(random, 0.05));
    }
  }
  TriangleMesh mesh;
  SurfaceQuery surface;
  std::vector<Eigen::Vector3d> asked;
};

void closestPoint(benchmark::State& state) {
  const Case test(static_cast<int>(state.range(0)));
  for (auto _ : state)
    for (const Eigen::Vector3d& p : test.asked) benchmark::DoNotOptimize(test.surface.closestPoint(p));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(test.asked.size()));
}

void signedDistance(benchmark::State& state) {
  const Case test(static_cast<int>(state.range(0)));
  for (auto _ : state)
    for (const Eigen::Vector3d& p : test.asked) benchmark::DoNotOptimize(test.surface.signedDistance(p));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(test.asked.size()));
}

void intersectRay(benchmark::State& state) {
  const Case test(static_cast<int>(state.range(0)));
  for (auto _ : state)
    for (const Eigen::Vector3d& p : test.asked)
      benchmark::DoNotOptimize(test.surface.intersectRay(p, Eigen::Vector3d(1, 0.3, 0.2)));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(test.asked.size()));
}

void refit(benchmark::State& state) {
  Case test(static_cast<int>(state.range(0)));
  for (auto _ : state) test.surface.refit(test.mesh.points);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(test.mesh.triangles.size()));
}

void build(benchmark::State& state) {
  const Case test(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(SurfaceQuery(test.mesh.points, test.mesh.triangles));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(test.mesh.triangles.size()));
}

BENCHMARK(closestPoint)->Arg(39)->Arg(122)->Arg(273);
BENCHMARK(signedDistance)->Arg(39)->Arg(122)->Arg(273);
BENCHMARK(intersectRay)->Arg(39)->Arg(122)->Arg(273);
BENCHMARK(refit)->Arg(39)->Arg(122)->Arg(273);
BENCHMARK(build)->Arg(39)->Arg(122)->Arg(273);

}  // namespace
}  // namespace pleura
