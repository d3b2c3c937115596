#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/haptics_device_node.h>

namespace pleura {

namespace {

void declareInputs(NodeType& type) {
  using enum Access;
  type.field<&HapticsDeviceNode::positionCalibration>("positionCalibration", inputOutput,
                                                      Matrix4f::Identity())
      .means("from the device's positions, scaled, to the scene's; its rotation turns forces too");
  type.field<&HapticsDeviceNode::orientationCalibration>("orientationCalibration", inputOutput, Rotation())
      .measuredIn(Unit::angle)
      .means("turn of the device's orientation after that of positionCalibration");
  type.field<&HapticsDeviceNode::workspaceScale>("workspaceScale", inputOutput, 1)
      .positive(1e6)
      .means("metres of the scene that a metre of the device's workspace stands for");
  type.field<&HapticsDeviceNode::followViewpoint>("followViewpoint", inputOutput, false)
      .means("whether the workspace stands before the viewer instead of in the scene");
  type.field<&HapticsDeviceNode::proxyRadius>("proxyRadius", inputOutput, 0.0025f)
      .measuredIn(Unit::length)
      .positive(1)
      .means("radius of the tip that touches");
  type.field<&HapticsDeviceNode::proxyWeighting>("proxyWeighting", inputOutput, 0.95f)
      .within(0, 1)
      .means("weightedProxyPosition: 1 is the proxy's position, 0 the tracker's");
  type.field<&HapticsDeviceNode::stylus>("stylus", inputOutput, {})
      .means("what is shown for it, its tip at the origin, its handle along +z");
  type.field<&HapticsDeviceNode::forceLimit>("forceLimit", inputOutput, -1)
      .measuredIn(Unit::force)
      .means("most force on the hand; -1: the device's own limit, which holds in any case");
  type.field<&HapticsDeviceNode::torqueLimit>("torqueLimit", inputOutput, -1)
      .means("most torque on the hand [N m]; -1: the device's own limit, which holds in any case");
  type.field<&HapticsDeviceNode::deadmansSwitch>("deadmansSwitch", inputOutput, false)
      .means("whether there is force only while the main button is pressed");
  type.field<&HapticsDeviceNode::desiredHapticsRate>("desiredHapticsRate", initializeOnly, 1000)
      .measuredIn(Unit::frequency)
      .within(100, 4000)
      .means("ticks of the haptic loop a second");
}

void declareOutputs(NodeType& type) {
  using enum Access;
  type.field<&HapticsDeviceNode::devicePosition>("devicePosition", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("of the tip, in the device's frame");
  type.field<&HapticsDeviceNode::deviceOrientation>("deviceOrientation", outputOnly, Rotation())
      .measuredIn(Unit::angle)
      .means("in the device's frame");
  type.field<&HapticsDeviceNode::deviceVelocity>("deviceVelocity", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::speed)
      .means("in the device's frame");
  type.field<&HapticsDeviceNode::trackerPosition>("trackerPosition", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("of the hand's tip in the scene; it may be inside of what is touched");
  type.field<&HapticsDeviceNode::trackerOrientation>("trackerOrientation", outputOnly, Rotation())
      .measuredIn(Unit::angle)
      .means("in the scene");
  type.field<&HapticsDeviceNode::trackerVelocity>("trackerVelocity", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::speed)
      .means("in the scene");
  type.field<&HapticsDeviceNode::proxyPosition>("proxyPosition", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means(
          "of the centre of the ball that stays outside of what is touched, as it is without being touched");
  type.field<&HapticsDeviceNode::weightedProxyPosition>("weightedProxyPosition", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("between proxyPosition and trackerPosition");
  type.field<&HapticsDeviceNode::tipPosition>("tipPosition", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("where the tip is seen: outside of what is rigid, pressed into what gives way");
  type.field<&HapticsDeviceNode::mainButton>("mainButton", outputOnly, false).means("pressed");
  type.field<&HapticsDeviceNode::secondaryButton>("secondaryButton", outputOnly, false).means("pressed");
  type.field<&HapticsDeviceNode::buttons>("buttons", outputOnly, 0).means("bit k: button k is pressed");
  type.field<&HapticsDeviceNode::force>("force", outputOnly, Vec3f::Zero())
      .measuredIn(Unit::force)
      .means("that the hand is given, in the scene");
  type.field<&HapticsDeviceNode::torque>("torque", outputOnly, Vec3f::Zero())
      .means("that the hand is given, in the scene [N m]");
  type.field<&HapticsDeviceNode::forceRotation>("forceRotation", outputOnly, Rotation())
      .measuredIn(Unit::angle)
      .means("turns +y to where the force points");
  type.field<&HapticsDeviceNode::forceScale>("forceScale", outputOnly, Vec3f::Ones())
      .means("1, newtons of the force, 1: for an arrow along y");
  type.field<&HapticsDeviceNode::depth>("depth", outputOnly, 0)
      .measuredIn(Unit::length)
      .means("from the proxy to the tracker while something is touched");
  type.field<&HapticsDeviceNode::touched>("touched", outputOnly, "")
      .means("DEF name of what is touched; empty: nothing");
  type.field<&HapticsDeviceNode::label>("label", outputOnly, {})
      .means("what people call it: the title in its metadata, or its DEF name; for Text.string");
  type.field<&HapticsDeviceNode::inputDOF>("inputDOF", outputOnly, 0)
      .means("degrees of freedom that it reads");
  type.field<&HapticsDeviceNode::outputDOF>("outputDOF", outputOnly, 0)
      .means("degrees of freedom that it drives");
  type.field<&HapticsDeviceNode::hapticsRate>("hapticsRate", outputOnly, 0)
      .measuredIn(Unit::frequency)
      .means("ticks of the haptic loop in the last second");
  type.field<&HapticsDeviceNode::hapticsLoopTime>("hapticsLoopTime", outputOnly, 0)
      .measuredIn(Unit::time)
      .means("that the last tick of the haptic loop took; 0 on the virtual clock");
  type.field<&HapticsDeviceNode::isConnected>("isConnected", outputOnly, false).means("whether it answers");
}

}  // namespace

void HapticsDeviceNode::declare(NodeType& type) {
  Node::declare(type);
  type.containedIn("device");
  declareInputs(type);
  declareOutputs(type);
}

}  // namespace pleura
