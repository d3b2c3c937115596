// A library with the symbols of OpenHaptics' libHD.so, for tests without hardware.
#include <algorithm>
#include <iterator>
#include <utility>

#include <pleura/tests/haptics/phantom/stand_in_hd.h>

using pleura::haptics::StandInHd;
namespace hd = pleura::haptics::hd;

namespace {

StandInHd state;

void fail(unsigned int code) {
  if (code != 0) state.errors.push_back({code, 7, 1});
}

void expect(bool isRight) { state.misuses += isRight ? 0 : 1; }

}  // namespace

extern "C" {

StandInHd* stand_in_state() { return &state; }

void stand_in_tick() {
  if (!state.isSchedulerRunning || state.callback == nullptr) return;
  if (state.callback(state.callbackData) == hd::kCallbackDone) state.callback = nullptr;
}

hd::Handle hdInitDevice(const char* configuration) {
  expect(!state.isOpen);
  state.configuration = configuration != nullptr ? configuration : "(default)";
  fail(state.isAbsent ? hd::kDeviceFault : state.errorAtInit);
  if (state.isAbsent || state.errorAtInit != 0) return hd::kInvalidHandle;
  state.isOpen = true;
  return 1;
}

void hdDisableDevice(hd::Handle device) {
  expect(device == 1 && state.isOpen && !state.isSchedulerRunning);
  state.isOpen = state.isForceEnabled = false;
  std::fill(std::begin(state.force), std::end(state.force), 0.0);
}

void hdMakeCurrentDevice(hd::Handle device) { expect(device == 1); }

void hdBeginFrame(hd::Handle device) {
  expect(device == 1 && state.isOpen && !state.isInFrame);
  state.isInFrame = true;
  if (state.isAbsent) fail(hd::kCommunicationError);
}

#ifndef PLEURA_TEST_WITHOUT_END_FRAME
void hdEndFrame(hd::Handle device) {
  expect(device == 1 && state.isInFrame);
  state.isInFrame = false;
  ++state.frames;
  fail(std::exchange(state.errorAtEndFrame, 0));
}
#endif

hd::ErrorInfo hdGetError() {
  if (state.errors.empty()) return {};
  const auto error = state.errors.back();
  state.errors.pop_back();
  return error;
}

const char* hdGetErrorString(unsigned int code) {
  return code == hd::kDeviceFault ? "Device fault" : nullptr;
}

void hdEnable(hd::Name what) {
  expect(what == hd::kForceOutput);
  state.isForceEnabled = true;
}

void hdGetIntegerv(hd::Name name, int* value) {
  switch (name) {
    case hd::kCurrentButtons:
      expect(state.isInFrame), *value = state.buttons;
      break;
    case hd::kInputDof:
      *value = 6;
      break;
    case hd::kOutputDof:
      *value = 3;
      break;
    case hd::kCalibrationStyle:
      *value = 4;
      break;
    default:
      expect(false);
  }
}

void hdGetDoublev(hd::Name name, double* values) {
  switch (name) {
    case hd::kCurrentTransform:
      expect(state.isInFrame), std::copy(std::begin(state.transform), std::end(state.transform), values);
      break;
    case hd::kCurrentVelocity:
      expect(state.isInFrame), std::copy(std::begin(state.velocity), std::end(state.velocity), values);
      break;
    case hd::kUsableWorkspace:
      std::copy(std::begin(state.workspace), std::end(state.workspace), values);
      break;
    case hd::kNominalMaxForce:
      *values = state.maxForce;
      break;
    case hd::kNominalMaxStiffness:
      *values = state.maxStiffness;
      break;
    case hd::kNominalMaxDamping:
      *values = state.maxDamping;
      break;
    default:
      expect(false);
  }
}

const char* hdGetString(hd::Name name) {
  expect(name == hd::kModelType);
  return state.model.c_str();
}

void hdSetDoublev(hd::Name name, const double* values) {
  expect(name == hd::kCurrentForce && state.isInFrame && state.isForceEnabled);
  std::copy(values, values + 3, std::begin(state.force));
}

hd::Name hdCheckCalibration() { return state.needsCalibration ? hd::kCalibrationNeedsUpdate : 0x5000; }

void hdUpdateCalibration(hd::Name style) {
  expect(style == 4);
  ++state.calibrations;
  state.needsCalibration = false;
}

void hdStartScheduler() {
  fail(state.errorAtScheduler);
  state.isSchedulerRunning = true;
}

void hdStopScheduler() { state.isSchedulerRunning = false; }

void hdScheduleSynchronous(hd::Callback callback, void* data, unsigned short) {
  expect(state.isSchedulerRunning);
  expect(callback(data) == hd::kCallbackDone);
}

hd::ScheduledCallback hdScheduleAsynchronous(hd::Callback callback, void* data, unsigned short) {
  expect(state.callback == nullptr);
  state.callback = callback;
  state.callbackData = data;
  return 1;
}

void hdUnschedule(hd::ScheduledCallback callback) {
  expect(callback == 1);
  state.callback = nullptr;
}

}  // extern "C"
