#include <pleura/nodes/haptic/any_device.h>
#include <pleura/nodes/haptic/device_info.h>
#include <pleura/nodes/haptic/force_field.h>
#include <pleura/nodes/haptic/frictional_surface.h>
#include <pleura/nodes/haptic/magnetic_surface.h>
#include <pleura/nodes/haptic/phantom_device.h>
#include <pleura/nodes/haptic/recorded_device.h>
#include <pleura/nodes/haptic/register.h>
#include <pleura/nodes/haptic/simulated_device.h>
#include <pleura/nodes/haptic/sine_function.h>
#include <pleura/nodes/haptic/smooth_surface.h>
#include <pleura/nodes/haptic/spring_effect.h>
#include <pleura/nodes/haptic/time_function_effect.h>
#include <pleura/nodes/haptic/tissue_surface.h>
#include <pleura/nodes/haptic/viscosity_effect.h>

namespace pleura {

void registerHapticNodes(NodeRegistry& registry) {
  registry.add<AnyDevice>();
  registry.add<DeviceInfo>();
  registry.add<ForceField>();
  registry.add<FrictionalSurface>();
  registry.add<MagneticSurface>();
  registry.add<PhantomDevice>();
  registry.add<RecordedDevice>();
  registry.add<SimulatedDevice>();
  registry.add<SineFunction>();
  registry.add<SmoothSurface>();
  registry.add<SpringEffect>();
  registry.add<TimeFunctionEffect>();
  registry.add<TissueSurface>();
  registry.add<ViscosityEffect>();
}

}  // namespace pleura
