#include <filesystem>

#include <benchmark/benchmark.h>

#include <pleura/haptics/servo/servo.h>
#include <pleura/haptics/simulated/simulated_stylus.h>
#include <pleura/x3d/browser/touch/touch_scene.h>

namespace pleura {
namespace {

/// The default thorax as the haptic loop has it, and a stylus that rests on left rib 4.
struct TouchedThorax {
  TouchedThorax()
      : stylus({.model = "benchmark",
                .maxForce = 22,
                .maxStiffness = 1000,
                .maxDamping = 5,
                .workspaceRadius = 0.25},
               haptics::StylusPath({{.time = 0, .position = {0.13, 0.06, 0.09}},
                                    {.time = 1, .position = {0.0984, 0.052, 0.0584}}}),
               {}) {
    scene.load(std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes/breathing_thorax.x3d");
    touch.emplace(scene);
    stylus.open();
    servo.emplace(stylus, 1e-3);
  }

  void publish(Time now) {
    scene.tick(now);
    touch->update();
    haptics::TouchFrame& frame = servo->frames().back();
    frame.duration = 1.0 / 30;
    touch->fill(frame, servo->stiffnessLimit(), servo->dampingLimit());
    servo->frames().publish();
  }

  Scene scene;
  std::optional<TouchScene> touch;
  haptics::SimulatedStylus stylus;
  std::optional<haptics::Servo> servo;
};

/// One tick of the haptic loop among all 71 touchable parts, interpolation included, the simulated stylus
/// too.
void hapticTick(benchmark::State& state) {
  TouchedThorax thorax;
  std::int64_t ticks = 0;
  for (auto _ : state) {
    if (ticks % 33 == 0) {
      state.PauseTiming();
      thorax.publish(static_cast<double>(ticks) * 1e-3);
      state.ResumeTiming();
    }
    thorax.servo->tick(static_cast<double>(ticks++) * 1e-3);
  }
  thorax.servo->reports().take();
  state.counters["contacts"] = thorax.servo->reports().taken().contactCount;
}
BENCHMARK(hapticTick)->Unit(benchmark::kMicrosecond)->Iterations(33000);

/// The scene handed over: every touchable part looked at, trees of what moved refitted. The scene's tick is
/// not in it.
void handOver(benchmark::State& state) {
  TouchedThorax thorax;
  double now = 0;
  for (int k = 0; k < 8; ++k) thorax.publish(now += 1.0 / 30);
  for (auto _ : state) {
    state.PauseTiming();
    thorax.scene.tick(now += 1.0 / 30);
    thorax.touch->update();
    state.ResumeTiming();
    thorax.touch->fill(thorax.servo->frames().back(), 400, 0.2);
    thorax.servo->frames().publish();
  }
}
BENCHMARK(handOver)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pleura
