#pragma once

#include <pleura/nodes/standard/time/x3d_time_dependent_node.h>

namespace pleura {

/// A clock that sends events as time passes.
class TimeSensor : public X3DTimeDependentNode {
 public:
  SFTime cycleInterval;
  SFBool enabled;
  SFBool loop;
  SFTime cycleTime;
  SFFloat fraction_changed;
  SFTime time;

  static void declare(NodeType& type);
};

}  // namespace pleura
