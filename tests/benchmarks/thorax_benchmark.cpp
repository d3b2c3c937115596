#include <filesystem>

#include <benchmark/benchmark.h>

#include <pleura/x3d/browser/scene/scene.h>

namespace pleura {
namespace {

/// A tick of the default thorax without drawing: every organ pulled once, as a picture or a haptic snapshot
/// would.
void tick(benchmark::State& state, const std::filesystem::path& anatomy) {
  Scene scene;
  ReaderLimits limits;
  limits.anatomyFolder = anatomy;
  scene.load(std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes/breathing_thorax.x3d", limits);
  auto& diaphragm = static_cast<MFVec3f&>(scene.field("DIAPHRAGM.deformedCoord"));
  auto& left = static_cast<MFVec3f&>(scene.field("LUNG_L.deformedCoord"));
  auto& right = static_cast<MFVec3f&>(scene.field("LUNG_R.deformedCoord"));
  double now = 0;
  const auto tickAndPull = [&] {
    scene.tick(now += 0.001);
    benchmark::DoNotOptimize(diaphragm.getValue().data());
    benchmark::DoNotOptimize(left.getValue().data());
    benchmark::DoNotOptimize(right.getValue().data());
  };
  tickAndPull();  // the first binds the organs to their walls, once
  for (auto _ : state) tickAndPull();
  state.counters["diaphragmPoints"] = static_cast<double>(diaphragm.size());
  state.counters["lungPoints"] = static_cast<double>(left.size() + right.size());
}

void generatedThorax(benchmark::State& state) { tick(state, {}); }
BENCHMARK(generatedThorax)->Unit(benchmark::kMillisecond);

/// On `./pleura anatomy --from ../shared/anatomy -o build/real-anatomy`.
void realThorax(benchmark::State& state) {
  const auto folder = std::filesystem::path(PLEURA_SOURCE_DIR) / "build/real-anatomy";
  if (!std::filesystem::exists(folder / "thorax.x3d"))
    return state.SkipWithError("build/real-anatomy is absent");
  tick(state, folder);
}
BENCHMARK(realThorax)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pleura
