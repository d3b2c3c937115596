#include <vector>

#include <benchmark/benchmark.h>

#include <pleura/fields/field_types.h>
#include <pleura/fields/typed_field.h>

namespace pleura {
namespace {

/// Seconds per `count` things of each iteration, shown as nanoseconds with an "n".
void reportPer(benchmark::State& state, const char* thing, std::size_t count) {
  using benchmark::Counter;
  state.counters[thing] =
      Counter(static_cast<double>(count), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

struct Chain {
  std::vector<SFFloat> fields;
  explicit Chain(benchmark::State& state) : fields(static_cast<std::size_t>(state.range(0)) + 1) {
    for (std::size_t i = 1; i < fields.size(); ++i) fields[i - 1].routeNoEvent(fields[i]);
  }
};

struct Fan {
  SFFloat hub;
  std::vector<SFFloat> rim;
  explicit Fan(benchmark::State& state) : rim(static_cast<std::size_t>(state.range(0))) {
    for (SFFloat& field : rim) hub.routeNoEvent(field);
  }
  void readAll() {
    for (SFFloat& field : rim) benchmark::DoNotOptimize(field.getValue());
  }
};

void chainSetAndGet(benchmark::State& state) {
  Chain chain(state);
  float value = 0;
  for (auto _ : state) {
    chain.fields.front().setValue(value += 1);
    benchmark::DoNotOptimize(chain.fields.back().getValue());
  }
  reportPer(state, "per_hop", chain.fields.size() - 1);
}
BENCHMARK(chainSetAndGet)->Arg(10)->Arg(100)->Arg(1'000)->Arg(100'000)->Arg(1'000'000);

/// The floor: objects in a list, marked one after the other and then evaluated by a virtual call each.
class Bare {
 public:
  virtual ~Bare() = default;
  Bare* from = nullptr;
  Bare* to = nullptr;
  bool isPending = false;
  float value = 0;

  virtual void update() { value = from->value; }
};

void bareChainSetAndGet(benchmark::State& state) {
  std::vector<Bare> chain(static_cast<std::size_t>(state.range(0)) + 1);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    chain[i - 1].to = &chain[i];
    chain[i].from = &chain[i - 1];
  }
  for (auto _ : state) {
    chain.front().value += 1;
    for (Bare* below = chain.front().to; below != nullptr; below = below->to) below->isPending = true;
    Bare* above = &chain.back();
    while (above->isPending) above = above->from;
    for (Bare* each = above->to; each != nullptr; each = each->to) {
      each->update();
      each->isPending = false;
    }
    benchmark::DoNotOptimize(chain.back().value);
  }
  reportPer(state, "per_hop", chain.size() - 1);
}
BENCHMARK(bareChainSetAndGet)->Arg(1'000)->Arg(1'000'000);

void chainSetUnread(benchmark::State& state) {
  Chain chain(state);
  float value = 0;
  for (auto _ : state) chain.fields.front().setValue(value += 1);
}
BENCHMARK(chainSetUnread)->Arg(1'000)->Arg(1'000'000);

void fanSet(benchmark::State& state) {
  Fan fan(state);
  float value = 0;
  for (auto _ : state) {
    fan.hub.setValue(value += 1);
    state.PauseTiming();
    fan.readAll();
    state.ResumeTiming();
  }
  reportPer(state, "per_edge", fan.rim.size());
}
BENCHMARK(fanSet)->Arg(10'000);

void fanGet(benchmark::State& state) {
  Fan fan(state);
  float value = 0;
  for (auto _ : state) {
    state.PauseTiming();
    fan.hub.setValue(value += 1);
    state.ResumeTiming();
    fan.readAll();
  }
  reportPer(state, "per_edge", fan.rim.size());
}
BENCHMARK(fanGet)->Arg(10'000);

void fanSetUnread(benchmark::State& state) {
  Fan fan(state);
  float value = 0;
  for (auto _ : state) fan.hub.setValue(value += 1);
}
BENCHMARK(fanSetUnread)->Arg(10'000);

class Sum : public TypedField<SFFloat, Types<SFFloat, SFFloat>> {
  void update() override {
    value = static_cast<SFFloat*>(routes_in[0])->getValue() + static_cast<SFFloat*>(routes_in[1])->getValue();
  }
};

/// Each joint is the sum of two fields that copy the joint before.
struct Diamonds {
  SFFloat top;
  std::vector<SFFloat> sides;
  std::vector<Sum> joints;
  explicit Diamonds(std::size_t depth) : sides(2 * depth), joints(depth) {
    for (std::size_t i = 0; i < depth; ++i)
      for (const std::size_t side : {2 * i, 2 * i + 1}) {
        if (i == 0) top.routeNoEvent(sides[side]);
        if (i > 0) joints[i - 1].routeNoEvent(sides[side]);
        sides[side].routeNoEvent(joints[i]);
      }
  }
};

void diamondsSetAndGet(benchmark::State& state) {
  Diamonds diamonds(static_cast<std::size_t>(state.range(0)));
  float value = 0;
  for (auto _ : state) {
    diamonds.top.setValue(value += 1);
    benchmark::DoNotOptimize(diamonds.joints.back().getValue());
  }
  reportPer(state, "per_edge", 4 * diamonds.joints.size());
}
BENCHMARK(diamondsSetAndGet)->Arg(20);

void diamondsSetUnread(benchmark::State& state) {
  Diamonds diamonds(static_cast<std::size_t>(state.range(0)));
  float value = 0;
  for (auto _ : state) diamonds.top.setValue(value += 1);
}
BENCHMARK(diamondsSetUnread)->Arg(20);

void makeAndUnmakeRoute(benchmark::State& state) {
  SFFloat from, to;
  for (auto _ : state) {
    from.route(to);
    from.unroute(to);
  }
}
BENCHMARK(makeAndUnmakeRoute);

/// A route stands within the two fields that it joins, or else in a list of each.
void memory(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(SFFloat());
  state.counters["bytes_SFFloat"] = sizeof(SFFloat);
  state.counters["bytes_MFVec3f"] = sizeof(MFVec3f);
  state.counters["bytes_per_route"] = 2 * sizeof(void*);
}
BENCHMARK(memory);

}  // namespace
}  // namespace pleura
