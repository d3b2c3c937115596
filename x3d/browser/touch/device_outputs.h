#pragma once

#include <string>

#include <pleura/haptics/servo/servo_report.h>
#include <pleura/nodes/haptic/haptics_device_node.h>
#include <pleura/x3d/browser/touch/touch_scene.h>

namespace pleura {

/// What a report says of what is touched that the loop doesn't know.
struct TouchedPart {
  TouchScene::Called called;                           // empty: nothing is touched
  Eigen::Vector3d givenWay = Eigen::Vector3d::Zero();  // [m] by which the tip has pressed in what gives way
};

/// Sets the device's outputs from the report, each that has changed.
void setOutputs(HapticsDeviceNode& device, const haptics::ServoReport& report, const TouchedPart& touched);

/// Sets the outputs of a touched shape's geometry for the device of that index, in the shape's frame; null
/// contact: it is not touched any more. `force` [N] on the hand, in the world.
void setOutputs(const TouchScene::Part& part, const haptics::ServoReport::Contact* contact,
                const Eigen::Vector3d& force, std::size_t device, std::size_t devices);

}  // namespace pleura
