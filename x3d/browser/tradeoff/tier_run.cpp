#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <malloc.h>

#include <pleura/nodes/deformable/deformer_node.h>
#include <pleura/x3d/browser/tradeoff/tier_run.h>

namespace pleura {

namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// [byte] that the program has got and not given back.
double allocated() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

std::shared_ptr<DeformerNode> deformerOf(Scene& scene, const DeformationTier& tier) {
  const NodeType* type = scene.registry().find(tier.node);
  auto deformer = type != nullptr ? std::dynamic_pointer_cast<DeformerNode>(type->create()) : nullptr;
  if (!deformer)
    throw std::invalid_argument("no deformer " + tier.node + ": the scene loads no library that has it");
  for (const auto& [field, text] : tier.fields) deformer->getField(field)->setValueFromString(text);
  deformer->initialize(scene);
  return deformer;
}

/// For a deformer that knows pressure at rest apart from pressure.
void press(DeformerNode& deformer, float pressure) {
  if (deformer.getField("restPressure") == nullptr) return;
  dynamic_cast<SFFloat&>(*deformer.getField("pressure")).setValue(pressure);
}

double quantile(const std::vector<double>& sorted, double q) {
  if (sorted.empty()) return 0;
  return sorted[static_cast<std::size_t>(std::lround(q * static_cast<double>(sorted.size() - 1)))];
}

bool hasConverged(DeformerNode& deformer) {
  auto* converged = dynamic_cast<SFBool*>(deformer.getField("converged"));
  return converged == nullptr || converged->getValue();
}

}  // namespace

TierRun runTier(Scene& scene, const OrganBreath& breath, const DeformationTier& tier,
                const std::function<void(double)>& progress) {
  TierRun run;
  run.figures.organ = breath.organ;
  run.figures.method = tier.method;
  run.figures.elements = tier.elements;
  if (tier.node.empty()) {
    for (const auto& moment : breath.moments) run.shapes.push_back(moment.filled);
    return run;
  }
  const double before = allocated();
  double begun = seconds();
  const auto deformer = deformerOf(scene, tier);
  deformer->setRest(breath.rest, breath.rigid);
  std::vector<Vec3f> positions = breath.rest.points;
  // The first asks for what was left to set up.
  const auto& first = breath.moments.front();
  press(*deformer, first.pressure);
  deformer->deform(breath.driven, first.targets, positions);
  const double withFirst = seconds() - begun;
  run.figures.memory = std::max(allocated() - before, 0.0);
  constexpr double kEnough = 0.2;  // [s] a moment
  constexpr int kMost = 50;
  std::vector<double> times;
  for (std::size_t k = 0; k < breath.moments.size(); ++k) {
    press(*deformer, breath.moments[k].pressure);
    double spent = 0;
    for (int repeat = 0; repeat < kMost && spent < kEnough; ++repeat) {
      begun = seconds();
      deformer->deform(breath.driven, breath.moments[k].targets, positions);
      times.push_back(seconds() - begun);
      spent += times.back();
    }
    run.shapes.push_back(positions);
    run.figures.converged = run.figures.converged && hasConverged(*deformer);
    progress(static_cast<double>(k + 1) / static_cast<double>(breath.moments.size()));
  }
  std::sort(times.begin(), times.end());
  run.figures.median = quantile(times, 0.5);
  run.figures.p99 = quantile(times, 0.99);
  run.figures.setUp = std::max(withFirst - run.figures.median, 0.0);
  return run;
}

}  // namespace pleura
