#pragma once

#include <optional>

#include <pleura/nodes/standard/core/field_watch.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/standard/interpolation/key_interval.h>

namespace pleura {

/// A node that goes from key value to key value as a fraction goes from key to key.
class X3DInterpolatorNode : public X3DChildNode {
 public:
  MFFloat key;
  SFFloat set_fraction;

  static void declare(NodeType& type);

 protected:
  /// Where `fraction` lies among the keys, `frames` being how many of them have values in `keyValue`; nothing
  /// when none has. Warns once when keys fall, or are not as many as values.
  std::optional<KeyInterval> locate(float fraction, Field& keyValue, std::size_t frames, bool isComplete);

 private:
  void check(bool isComplete);

  FieldWatch watch_;
  bool hasWarned_ = false;
};

}  // namespace pleura
