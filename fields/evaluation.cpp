#include <pleura/fields/counters.h>
#include <pleura/fields/field.h>

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
  const Event pending = event;
  if (inputsChanged_) {
    checkInputs();
    inputsChanged_ = false;
  }
  unsettle(pending.sender);  // before update(), which may set what is upstream
  ++fieldCounters().updates;
  update();
  if (observes_) forgetEvents(nullptr, pending.stamp);
  if (event.stamp == pending.stamp) event.sender = nullptr;  // else it has changed again meanwhile
}

/// Depth first, inputs before what reads them, `this` left to the caller.
void Field::evaluatePendingInputs() {
  struct Step {
    Field* field;
    std::size_t next;
  };
  struct Path {
    std::vector<Step> steps;
    ~Path() {
      for (const Step& step : steps) step.field->evaluating_ = false;
    }
  } path;
  Step step{this, 0};
  evaluating_ = true;
  while (true) {
    if (step.next < step.field->routes_in.size()) {
      Field* input = step.field->routes_in[step.next++];
      if (input->isUpToDate() || input->evaluating_) continue;
      path.steps.push_back(step);
      input->evaluating_ = true;
      step = {input, 0};
      continue;
    }
    if (path.steps.empty()) return;
    step.field->runUpdate();
    step = path.steps.back();
    path.steps.pop_back();
  }
}

}  // namespace pleura
