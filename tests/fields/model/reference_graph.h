#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include <pleura/tests/fields/model/rules.h>

namespace pleura::model {

struct FieldKind {
  Rule rule = Rule::copy;
  bool isAuto = false;        // AutoUpdate
  bool isCollecting = false;  // EventCollectingField
  int target = -1;            // what Rule::setter sets
};

/// What the headers of fields/ say, by the shortest code that does it: every event is carried to every field
/// it can reach, by recursion; no field is passed by because it is out of date already.
class ReferenceGraph {
 public:
  struct Node {
    FieldKind kind;
    std::vector<int> in, out;
    int sender = -1;
    std::uint64_t stamp = 0;
    std::int32_t value = 0;
    bool isEvaluating = false;
    std::vector<Cause> causes;  // here `sender` is a node, not a place
  };
  std::vector<Node> nodes;
  std::vector<int> updates;  // which field was updated, in order
  std::uint64_t lastStamp = 0;

  explicit ReferenceGraph(int count) : nodes(static_cast<std::size_t>(count)) {}
  Node& at(int i) { return nodes[static_cast<std::size_t>(i)]; }

  std::int32_t get(int i) {
    Node& node = at(i);
    if (node.sender < 0 || node.isEvaluating) return node.value;
    node.isEvaluating = true;
    const std::uint64_t pending = node.stamp;
    updates.push_back(i);
    View view{*this, i};
    node.value = model::evaluate(node.kind.rule, view);
    std::erase_if(node.causes, [&](const Cause& c) { return c.stamp <= pending; });
    if (node.stamp == pending) node.sender = -1;
    node.isEvaluating = false;
    return node.value;
  }

  void set(int i, std::int32_t value) {
    at(i).value = value;
    at(i).sender = -1;
    at(i).causes.clear();
    at(i).stamp = ++lastStamp;
    for (const int to : at(i).out) arrive(i, to);
    callObservers();
  }

  void setIfChanged(int i, std::int32_t value) {
    if (get(i) != value) set(i, value);
  }

  void routeNoEvent(int from, int to) {
    if (routes(from, to)) return;
    at(from).out.push_back(to);
    at(to).in.push_back(from);
  }

  void route(int from, int to) {
    if (routes(from, to)) return;
    routeNoEvent(from, to);
    at(from).stamp = ++lastStamp;
    arrive(from, to);
    callObservers();
  }

  void unroute(int from, int to) {
    std::erase(at(from).out, to);
    std::erase(at(to).in, from);
    std::erase_if(at(to).causes, [&](const Cause& c) { return c.sender == from; });
    if (at(to).sender == from) at(to).sender = -1;
  }

  void replace(int i, FieldKind kind) {
    while (!at(i).out.empty()) unroute(i, at(i).out.back());
    while (!at(i).in.empty()) unroute(at(i).in.back(), i);
    at(i) = Node{};
    at(i).kind = kind;
  }

 private:
  struct View {
    ReferenceGraph& graph;
    int self;

    Node& node() { return graph.at(self); }
    int inputs() { return static_cast<int>(node().in.size()); }
    int place(int sender) {
      return static_cast<int>(std::find(node().in.begin(), node().in.end(), sender) - node().in.begin());
    }
    int lastSender() { return place(node().sender); }
    std::int32_t read(int i) { return graph.get(node().in[static_cast<std::size_t>(i)]); }
    std::int32_t before() { return node().value; }
    std::vector<Cause> causes() {
      std::vector<Cause> all = node().causes;
      for (Cause& cause : all) cause.sender = place(cause.sender);
      return all;
    }
    void setTarget(std::int32_t value) { graph.set(node().kind.target, value); }
  };

  bool routes(int from, int to) {
    return std::find(at(from).out.begin(), at(from).out.end(), to) != at(from).out.end();
  }

  void arrive(int from, int to) {
    Node& node = at(to);
    if (node.kind.isCollecting) collect(node, from);
    if (node.kind.isAuto && std::find(observers_.begin(), observers_.end(), to) == observers_.end())
      observers_.push_back(to);
    if (node.stamp >= lastStamp) return;
    node.stamp = lastStamp;
    node.sender = from;
    for (const int next : node.out) arrive(to, next);
  }

  void collect(Node& node, int from) {
    for (Cause& known : node.causes)
      if (known.sender == from) {
        known.stamp = lastStamp;
        return;
      }
    node.causes.push_back({from, lastStamp});
  }

  void callObservers() {
    if (isCalling_) return;
    isCalling_ = true;
    while (!observers_.empty()) {
      const int next = observers_.front();
      observers_.pop_front();
      get(next);
    }
    isCalling_ = false;
  }

  std::deque<int> observers_;
  bool isCalling_ = false;
};

}  // namespace pleura::model
