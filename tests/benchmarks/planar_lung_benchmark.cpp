#include <benchmark/benchmark.h>

#include <pleura/tests/nodes/lung/planar/breath.h>

namespace pleura {
namespace {

using planar::effort;
using planar::kQuiet;

struct Peak {
  double dome, pressure;
};

/// The chest 1.3 s into a quiet breath from rest, when the muscles pull hardest.
Peak inhale(double step) {
  PlanarLungSystem system = planar::drawnOut();
  for (int k = 1; k <= std::lround(1.3 / step); ++k) system.step(step, effort(k * step) * kQuiet);
  return {system.chest()[0], system.pressure(0)};
}

/// Quiet breaths at a step of so many milliseconds. speed: simulated seconds a second; dome_mm and
/// pressure_Pa: how far the peak is from that at a step ten times smaller.
void breathe(benchmark::State& state) {
  const double step = static_cast<double>(state.range(0)) / 1000;
  PlanarLungSystem system = planar::drawnOut();
  double time = 0;
  long iterations = 0;
  bool isConverged = true;
  for (auto _ : state) {
    time += step;
    const PlanarLungStatus status = system.step(step, effort(time) * kQuiet);
    iterations += status.iterations;
    isConverged = isConverged && status.isConverged;
  }
  if (!isConverged) state.SkipWithError("a step did not converge");
  const Peak coarse = inhale(step);
  const Peak fine = inhale(step / 10);
  state.counters["speed"] = benchmark::Counter(step, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["iterations"] =
      benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kAvgIterations);
  state.counters["dome_mm"] = 1e3 * std::abs(coarse.dome - fine.dome);
  state.counters["pressure_Pa"] = std::abs(coarse.pressure - fine.pressure);
}
BENCHMARK(breathe)->ArgName("step_ms")->Arg(10)->Arg(20)->Arg(50)->Unit(benchmark::kMicrosecond);

void collapse(benchmark::State& state) {
  const PlanarLungSystem drawnOut = planar::drawnOut();
  for (auto _ : state) {
    PlanarLungSystem system = drawnOut;
    system.setPressure(0, 0);
    for (int k = 0; k < 40; ++k) benchmark::DoNotOptimize(system.step(0.05, planar::kNone));
  }
}
BENCHMARK(collapse)->Unit(benchmark::kMillisecond);

void drawOut(benchmark::State& state) {
  const PlanarLungSystem natural{PlanarLungParameters{}};
  for (auto _ : state) {
    PlanarLungSystem system = natural;
    benchmark::DoNotOptimize(system.drawOut());
  }
}
BENCHMARK(drawOut)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pleura
