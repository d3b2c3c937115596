#pragma once

#include <cstdint>
#include <vector>

namespace pleura::model {

/// How a field of a random graph computes its value. Each shows something else of the evaluation: who sent
/// last, how often it was evaluated, which inputs it reads.
enum class Rule : std::uint8_t {
  copy,    // of the last sender: what a plain field does
  sum,     // of all inputs, weighted by place
  first,   // reads one input only
  choice,  // which inputs it reads hangs on what it reads
  sender,  // reads nothing: place of the last sender, and its own value of before
  causes,  // place and stamp of each that sent an event since the last evaluation
  setter,  // sets another field as it is evaluated
};

struct Cause {
  int sender;  // place in routes_in
  std::uint64_t stamp;
};

constexpr std::int32_t kModulus = 1'000'003;

constexpr std::int32_t mix(std::int64_t a, std::int64_t b) {
  return static_cast<std::int32_t>((a * 131 + b * 7 + 11) % kModulus);
}

/// The new value; `view` is the field as its own update() sees it.
template <class View>
std::int32_t evaluate(Rule rule, View& view) {
  const int inputs = view.inputs();
  std::int32_t result = 1;
  switch (rule) {
    case Rule::copy:
      return view.read(view.lastSender());
    case Rule::sum:
      for (int i = 0; i < inputs; ++i) result = mix(result, view.read(i));
      return result;
    case Rule::first:
      return inputs > 0 ? mix(2, view.read(0)) : 0;
    case Rule::choice: {
      const std::int32_t chosen = inputs > 0 ? view.read(0) : 0;
      return chosen % 2 == 1 ? mix(3, view.read(inputs - 1)) : chosen + 3;
    }
    case Rule::sender:
      return mix(view.before(), view.lastSender());
    case Rule::causes:
      for (const Cause& cause : view.causes())
        result = mix(mix(result, cause.sender), static_cast<std::int64_t>(cause.stamp % kModulus));
      return result;
    case Rule::setter:
      result = mix(5, inputs > 0 ? view.read(0) : 0);
      if (result % 3 != 0) view.setTarget(result);
      return result;
  }
  return 0;
}

}  // namespace pleura::model
