#pragma once

#include <pleura/nodes/standard/core/x3d_sensor_node.h>

namespace pleura {

/// FIXME.
class X3DKeyDeviceSensorNode : public X3DSensorNode {};

}  // namespace pleura
