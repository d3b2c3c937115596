#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <pleura/tests/fields/model/field_graph.h>
#include <pleura/tests/fields/model/reference_graph.h>

namespace pleura::model {
namespace {

/// What a random graph may hold. An AutoUpdate that sets one of its own causes never ends, so setters set
/// downstream only where there are AutoUpdates, and anything where there are none.
struct Mix {
  const char* name;
  int fields;
  double routesPerField;
  bool hasAutoUpdates;
  bool setsAnything;
};

class RandomGraph : public testing::TestWithParam<Mix> {
 protected:
  void start(unsigned seed) {
    random_.seed(seed);
    for (int i = 0; i < mix_.fields; ++i) replace(i);
    for (int i = 0; i < mix_.fields * mix_.routesPerField; ++i) connect();
  }

  void step() {
    const int chance = below(100);
    const int i = below(mix_.fields);
    if (chance < 35) return set(i);
    if (chance < 65) return read(i);
    if (chance < 67) return readAll();
    if (chance < 80) return connect();
    if (chance < 93) return disconnect(i);
    if (chance < 97) return setIfChanged(i);
    replace(i);
  }

  void expectSame() {
    ASSERT_EQ(fields_.updates, reference_.updates) << "fields updated, in order";
    fields_.updates.clear();
    reference_.updates.clear();
    for (int i = 0; i < mix_.fields; ++i)
      ASSERT_EQ(fields_.senderOf(i), reference_.at(i).sender) << "pending at " << i;
  }

  std::string log_;

 private:
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  void note(const char* what, int i, int j = -1) {
    log_ = j < 0 ? fmt::format("{} {}", what, i) : fmt::format("{} {} {}", what, i, j);
  }

  void set(int i) {
    const int value = below(kModulus);
    note("set", i);
    fields_.at(i).setValue(value);
    reference_.set(i, value);
  }

  void setIfChanged(int i) {
    const int value = below(2) == 0 ? reference_.at(i).value : below(kModulus);
    note("setValueIfChanged", i);
    fields_.at(i).setValueIfChanged(value);
    reference_.setIfChanged(i, value);
  }

  void read(int i) {
    note("read", i);
    ASSERT_EQ(fields_.at(i).getValue(), reference_.get(i)) << "value of " << i;
  }

  void readAll() {
    for (int i = 0; i < mix_.fields; ++i) read(i);
  }

  void connect() {
    const int from = below(mix_.fields);
    const int to = below(mix_.fields);
    if (isDownstream(from) && !isDownstream(to)) return;
    note("route", from, to);
    if (below(3) == 0) {
      fields_.at(from).routeNoEvent(fields_.at(to));
      reference_.routeNoEvent(from, to);
    } else {
      fields_.at(from).route(fields_.at(to));
      reference_.route(from, to);
    }
  }

  void disconnect(int from) {
    const auto& out = reference_.at(from).out;
    if (out.empty()) return;
    const int to = out[static_cast<std::size_t>(below(static_cast<int>(out.size())))];
    note("unroute", from, to);
    fields_.at(from).unroute(fields_.at(to));
    reference_.unroute(from, to);
  }

  void replace(int i) {
    FieldKind kind;
    kind.rule = static_cast<Rule>(below(7));
    kind.isAuto = mix_.hasAutoUpdates && below(6) == 0;
    kind.isCollecting = kind.rule == Rule::causes || below(6) == 0;
    kind.target = mix_.setsAnything ? below(mix_.fields) : mix_.fields - 1 - below(mix_.fields / 4);
    if (kind.rule == Rule::setter && isDownstream(i)) kind.rule = Rule::sum;
    note("replace", i);
    fields_.replace(i, kind);
    reference_.replace(i, kind);
  }

  /// What setters set, where they may not set anything: it has no route back and sets nothing itself.
  bool isDownstream(int i) const { return !mix_.setsAnything && i >= mix_.fields - mix_.fields / 4; }

  const Mix mix_ = GetParam();
  std::mt19937 random_;
  FieldGraph fields_{mix_.fields};
  ReferenceGraph reference_{mix_.fields};
};

TEST_P(RandomGraph, BehavesAsTheReference) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    start(seed);
    for (int i = 0; i < 500; ++i) {
      step();
      if (!HasFailure()) expectSame();
      ASSERT_FALSE(HasFailure()) << "seed " << seed << ", step " << i << ": " << log_;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, RandomGraph,
    testing::Values(Mix{"FewRoutes", 12, 1.0, false, true}, Mix{"ManyRoutes", 12, 2.5, false, true},
                    Mix{"Tiny", 5, 1.5, false, true}, Mix{"FewRoutesAutoUpdate", 16, 1.0, true, false},
                    Mix{"ManyRoutesAutoUpdate", 16, 2.5, true, false}, Mix{"Large", 60, 1.3, true, false}),
    [](const auto& mix) { return mix.param.name; });

}  // namespace
}  // namespace pleura::model
