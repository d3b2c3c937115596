#include <vector>

#include <pleura/fields/counters.h>
#include <pleura/fields/field.h>
#include <pleura/fields/propagation.h>

namespace pleura {

namespace {

/// How deep update() may call itself through getValue() before what is pending below is evaluated in a loop.
/// Up to here evaluation is as lazy as each update() is; beyond it all pending inputs are evaluated, read or
/// not.
constexpr int kDeepestRecursion = 128;

thread_local int depth = 0;

struct Deeper {
  Deeper() { ++depth; }
  ~Deeper() { --depth; }
};

}  // namespace

void Field::evaluate() {
  if (evaluating_) return;  // a cycle: it gets the value of before
  if (depth >= kDeepestRecursion) evaluatePendingInputs();
  runUpdate();
}

void Field::runUpdate() {
  struct Evaluating {
    Field& field;
    explicit Evaluating(Field& f) : field(f) { field.evaluating_ = true; }
    ~Evaluating() { field.evaluating_ = false; }
  } const evaluating{*this};
  const Deeper deeper;
  const std::uint64_t begun = Propagation::lastStamp();
  const std::uint64_t pending = event.stamp;
  if (inputsChanged_) {
    checkInputs();
    inputsChanged_ = false;
  }
  ++fieldCounters().updates;
  update();
  if (observes_) forgetEvents(nullptr, pending);
  if (event.stamp > begun) return;  // it has changed again meanwhile
  if (Field* const sender = event.sender; sender != nullptr && sender->settled_) {
    if (Propagation::isPassedOver(*this, begun + 1)) return;
    unsettle(sender);  // after update(), which has brought most of what is upstream up to date
  }
  event.sender = nullptr;
}

/// Depth first, inputs before what reads them, `this` left to the caller.
void Field::evaluatePendingInputs() {
  struct Step {
    Field* field;
    std::size_t next;
  };
  // One a thread, reused: its pages cost more than the evaluation. Calls within calls stack theirs on it.
  thread_local std::vector<Step> steps;
  struct Path {
    const std::size_t base = steps.size();
    ~Path() {
      for (std::size_t i = base; i < steps.size(); ++i) steps[i].field->evaluating_ = false;
      steps.resize(base);
    }
  } const path;
  Step step{this, 0};
  evaluating_ = true;
  while (true) {
    if (step.next < step.field->routes_in.size()) {
      Field* input = step.field->routes_in[step.next++];
      if (input->isUpToDate() || input->evaluating_) continue;
      steps.push_back(step);
      input->evaluating_ = true;
      step = {input, 0};
      continue;
    }
    if (steps.size() == path.base) return;
    step.field->runUpdate();
    step = steps.back();
    steps.pop_back();
  }
}

}  // namespace pleura
