#pragma once

#include <filesystem>

namespace pleura::haptics::hd {

// The part of OpenHaptics' HD interface (3.x) that a driver needs: types and values as its vendor published
// them, under names of our own.

using Handle = unsigned int;
using Name = unsigned int;  // HDenum
using Boolean = unsigned char;
using CallbackCode = unsigned int;
using Callback = CallbackCode (*)(void*);
using ScheduledCallback = unsigned long;

struct ErrorInfo {
  unsigned int code = 0;
  int internalCode = 0;
  Handle device = 0;
};

constexpr Handle kInvalidHandle = 0xFFFFFFFF;
constexpr CallbackCode kCallbackDone = 0, kCallbackContinue = 1;
constexpr unsigned short kDefaultPriority = 0x7FFF;

constexpr unsigned int kSuccess = 0;
constexpr unsigned int kForceErrors = 0x0200;  // to 0x02FF: motors warm, force or speed exceeded
constexpr unsigned int kDeviceFault = 0x0300, kCommunicationError = 0x0302;

// hdGetIntegerv
constexpr Name kCurrentButtons = 0x2000, kInputDof = 0x2553, kOutputDof = 0x2554, kCalibrationStyle = 0x2555;
// hdGetDoublev
constexpr Name kCurrentVelocity = 0x2051;      // 3 [mm/s]
constexpr Name kCurrentTransform = 0x2052;     // 4 x 4, column by column; position [mm]
constexpr Name kUsableWorkspace = 0x2551;      // least x, y, z, most x, y, z [mm]
constexpr Name kNominalMaxStiffness = 0x2602;  // [N/mm]
constexpr Name kNominalMaxForce = 0x2603;      // [N]
constexpr Name kNominalMaxDamping = 0x2609;    // [N s/mm]
// hdSetDoublev
constexpr Name kCurrentForce = 0x2700;  // 3 [N]
// hdGetString
constexpr Name kModelType = 0x2501;
// hdEnable
constexpr Name kForceOutput = 0x4000;
// hdCheckCalibration
constexpr Name kCalibrationNeedsUpdate = 0x5001;

/// The functions, each named after its symbol.
struct Api {
  Handle (*initDevice)(const char* configuration) = nullptr;
  void (*disableDevice)(Handle) = nullptr;
  void (*makeCurrentDevice)(Handle) = nullptr;
  void (*beginFrame)(Handle) = nullptr;
  void (*endFrame)(Handle) = nullptr;
  ErrorInfo (*getError)() = nullptr;
  const char* (*getErrorString)(unsigned int code) = nullptr;
  void (*enable)(Name) = nullptr;
  void (*getIntegerv)(Name, int*) = nullptr;
  void (*getDoublev)(Name, double*) = nullptr;
  const char* (*getString)(Name) = nullptr;
  void (*setDoublev)(Name, const double*) = nullptr;
  Name (*checkCalibration)() = nullptr;
  void (*updateCalibration)(Name style) = nullptr;
  void (*startScheduler)() = nullptr;
  void (*stopScheduler)() = nullptr;
  void (*scheduleSynchronous)(Callback, void*, unsigned short priority) = nullptr;
  ScheduledCallback (*scheduleAsynchronous)(Callback, void*, unsigned short priority) = nullptr;
  void (*unschedule)(ScheduledCallback) = nullptr;
};

/// The vendor's library: PLEURA_HD_LIBRARY if the environment has it, otherwise libHD.so where the system
/// looks.
std::filesystem::path libraryPath();

/// Loads it for as long as the process lives, since it has threads of its own. Throws DeviceError, naming the
/// library or the symbol that it lacks.
Api load(const std::filesystem::path& library);

}  // namespace pleura::haptics::hd
