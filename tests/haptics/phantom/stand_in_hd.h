#pragma once

#include <deque>
#include <string>

#include <pleura/haptics/phantom/hd_api.h>

namespace pleura::haptics {

/// What the stand-in for the vendor's library is, was told and shall do. Its scheduler ticks when the test
/// says so.
struct StandInHd {
  // The device.
  std::string model = "PHANTOM Omni";
  double transform[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  double velocity[3] = {0, 0, 0};
  int buttons = 0;
  double workspace[6] = {-100, -60, -40, 100, 80, 40};
  double maxForce = 3.3, maxStiffness = 0.5, maxDamping = 0.004;
  bool needsCalibration = false;

  // What shall go wrong.
  bool isAbsent = false;             // hdInitDevice and frames fail
  std::deque<hd::ErrorInfo> errors;  // as hdGetError gives them
  unsigned int errorAtInit = 0, errorAtScheduler = 0, errorAtEndFrame = 0;

  // What was done.
  std::string configuration;
  double force[3] = {0, 0, 0};
  bool isOpen = false, isForceEnabled = false, isSchedulerRunning = false, isInFrame = false;
  int frames = 0, misuses = 0, calibrations = 0;
  hd::Callback callback = nullptr;
  void* callbackData = nullptr;
};

using StandInState = StandInHd* (*)();
using StandInTick = void (*)();

}  // namespace pleura::haptics
