#include <cstdlib>

#include <dlfcn.h>
#include <fmt/format.h>

#include <pleura/haptics/device/haptic_device.h>
#include <pleura/haptics/phantom/hd_api.h>

namespace pleura::haptics::hd {

std::filesystem::path libraryPath() {
  const char* path = std::getenv("PLEURA_HD_LIBRARY");
  return path != nullptr && *path != '\0' ? path : "libHD.so";
}

Api load(const std::filesystem::path& library) {
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr)
    throw DeviceError(
        fmt::format("the library of Phantom devices can't be loaded ({}): install OpenHaptics, or "
                    "set PLEURA_HD_LIBRARY to its libHD.so",
                    dlerror()));
  Api api;
  const auto find = [&](const char* symbol, auto& function) {
    void* found = dlsym(handle, symbol);
    if (found == nullptr)
      throw DeviceError(
          fmt::format("{} is no HD library of OpenHaptics 3: it lacks {}", library.string(), symbol));
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(found);
  };
  find("hdInitDevice", api.initDevice);
  find("hdDisableDevice", api.disableDevice);
  find("hdMakeCurrentDevice", api.makeCurrentDevice);
  find("hdBeginFrame", api.beginFrame);
  find("hdEndFrame", api.endFrame);
  find("hdGetError", api.getError);
  find("hdGetErrorString", api.getErrorString);
  find("hdEnable", api.enable);
  find("hdGetIntegerv", api.getIntegerv);
  find("hdGetDoublev", api.getDoublev);
  find("hdGetString", api.getString);
  find("hdSetDoublev", api.setDoublev);
  find("hdCheckCalibration", api.checkCalibration);
  find("hdUpdateCalibration", api.updateCalibration);
  find("hdStartScheduler", api.startScheduler);
  find("hdStopScheduler", api.stopScheduler);
  find("hdScheduleSynchronous", api.scheduleSynchronous);
  find("hdScheduleAsynchronous", api.scheduleAsynchronous);
  find("hdUnschedule", api.unschedule);
  return api;
}

}  // namespace pleura::haptics::hd
