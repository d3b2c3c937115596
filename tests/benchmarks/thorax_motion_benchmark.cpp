#include <benchmark/benchmark.h>

#include <pleura/nodes/thorax/motion/thorax_motion.h>

namespace pleura {
namespace {

/// One evaluation of bones, walls, diaphragm and lungs of the default thorax; inflation changes at every
/// call.
void evaluateThorax(benchmark::State& state) {
  ThoraxMotion motion(generateAnatomy());
  double inflation = 0.0;
  for (auto _ : state) {
    motion.evaluate(inflation);
    benchmark::DoNotOptimize(motion.lung(0).data());
    inflation = inflation < 1.0 ? inflation + 0.01 : 0.0;
  }
}
BENCHMARK(evaluateThorax)->Unit(benchmark::kMicrosecond);

void buildThorax(benchmark::State& state) {
  const Anatomy anatomy = generateAnatomy();
  for (auto _ : state) benchmark::DoNotOptimize(ThoraxMotion(anatomy));
}
BENCHMARK(buildThorax)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pleura
