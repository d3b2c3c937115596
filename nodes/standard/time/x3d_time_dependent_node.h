#pragma once

#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A node that runs from a start time on, may pause, and stops (X3D 8.2.4).
class X3DTimeDependentNode : public X3DChildNode {
 public:
  SFString description;
  SFTime pauseTime;
  SFTime resumeTime;
  SFTime startTime;
  SFTime stopTime;
  SFTime elapsedTime;
  SFBool isActive;
  SFBool isPaused;

  static void declare(NodeType& type);
};

}  // namespace pleura
