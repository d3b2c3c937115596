#pragma once

#include <pleura/haptics/servo/touch_frame.h>
#include <pleura/nodes/haptic/haptics_device_node.h>
#include <pleura/nodes/standard/navigation/x3d_viewpoint_node.h>

namespace pleura {

/// How the device's workspace stands in the scene. `viewpoint` may be null; `viewpointToWorld` is of the
/// group it stands in. Of a calibration that stretches the axes unequally the mean is taken.
haptics::Workspace workspaceOf(HapticsDeviceNode& device, X3DViewpointNode* viewpoint,
                               const Matrix4f& viewpointToWorld);

}  // namespace pleura
