#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <pleura/fields/nearest_name.h>
#include <pleura/haptics/device/device_presets.h>
#include <pleura/haptics/phantom/phantom_device.h>
#include <pleura/haptics/safety/force_limiter.h>

namespace pleura::haptics {

namespace {

constexpr int kTicksAForceIsHeld = 20;
constexpr double kLongestSilence = 0.1;  // [s]
constexpr double kMillimetre = 0.001;    // [m]
// HD keeps errors on a stack; a broken library may report for ever.
constexpr int kMostErrors = 32;

std::atomic<bool> isSchedulerTaken = false;

/// The first error that means more than that motors are off for a while; code 0: none.
hd::ErrorInfo firstFailure(const hd::Api& api) {
  for (int i = 0; i < kMostErrors; ++i) {
    const auto error = api.getError();
    if (error.code == hd::kSuccess || (error.code & 0xFF00) != hd::kForceErrors) return error;
  }
  return {.code = hd::kDeviceFault};
}

/// The preset whose name is part of the model's; null: none.
const DeviceCapabilities* presetOf(std::string_view model) {
  for (const auto& preset : devicePresets())
    for (std::size_t at = 0; at + preset.model.size() <= model.size(); ++at)
      if (isSameName(model.substr(at, preset.model.size()), preset.model)) return &preset;
  return nullptr;
}

}  // namespace

PhantomDevice::PhantomDevice(std::string configuration)
    : configuration_(std::move(configuration)), capabilities_(devicePreset("Touch")) {}

void PhantomDevice::open() {
  close();
  if (!api_) api_ = hd::load(hd::libraryPath());
  if (isSchedulerTaken.exchange(true))
    throw DeviceError("another Phantom device is open: HD has one scheduler a process, close it first");
  isHolder_ = true;
  try {
    start();
  } catch (...) {
    close();
    throw;
  }
}

void PhantomDevice::start() {
  device_ = api_->initDevice(configuration_.empty() ? nullptr : configuration_.c_str());
  throwOnError("be opened");
  if (device_ == hd::kInvalidHandle)
    throw DeviceError("the Phantom device can't be opened: HD gave no handle");
  api_->makeCurrentDevice(device_);
  queryCapabilities();
  api_->enable(hd::kForceOutput);
  throwOnError("give force");

  forces_.take(force_);  // what was left from before is not to be given
  force_.setZero();
  states_.take(state_);
  ticksSinceForce_ = 0;
  lastNews_.reset();
  isLost_ = false;
  api_->startScheduler();
  throwOnError("start its scheduler");
  api_->scheduleSynchronous(exchangeOnce, this, hd::kDefaultPriority);
  throwOnError("tell where it is");
  if (!states_.take(state_)) throw DeviceError("the Phantom device can't tell where it is");
  callback_ = api_->scheduleAsynchronous(exchangeEachTick, this, hd::kDefaultPriority);
  throwOnError("be driven");
}

void PhantomDevice::close() noexcept {
  isLost_ = true;
  if (!std::exchange(isHolder_, false)) return;
  api_->stopScheduler();
  if (callback_) api_->unschedule(*callback_);
  callback_.reset();
  // It is the device's end of force, too.
  if (device_ != hd::kInvalidHandle) api_->disableDevice(std::exchange(device_, hd::kInvalidHandle));
  isSchedulerTaken = false;
}

void PhantomDevice::queryCapabilities() {
  const auto number = [this](hd::Name name, double unit, double& figure) {
    double value = 0;
    api_->getDoublev(name, &value);
    if (std::isfinite(value) && value > 0) figure = value * unit;
  };
  const auto count = [this](hd::Name name, int& figure) {
    int value = 0;
    api_->getIntegerv(name, &value);
    if (value > 0) figure = value;
  };
  const char* told = api_->getString(hd::kModelType);
  const std::string model = told != nullptr ? told : "";
  const auto* preset = presetOf(model);
  capabilities_ = preset != nullptr ? *preset : devicePreset("Touch");
  if (!model.empty()) capabilities_.model = model;
  number(hd::kNominalMaxForce, 1, capabilities_.maxForce);
  number(hd::kNominalMaxStiffness, 1 / kMillimetre, capabilities_.maxStiffness);
  number(hd::kNominalMaxDamping, 1 / kMillimetre, capabilities_.maxDamping);
  count(hd::kInputDof, capabilities_.inputDof);
  count(hd::kOutputDof, capabilities_.outputDof);

  std::array<double, 6> box{};
  api_->getDoublev(hd::kUsableWorkspace, box.data());
  const Eigen::Vector3d least(box[0], box[1], box[2]), most(box[3], box[4], box[5]);
  const double shortest = (most - least).minCoeff() / 2;
  if (std::isfinite(shortest) && shortest > 0) {
    origin_ = (least + most) / 2;
    capabilities_.workspaceRadius = shortest * kMillimetre;
  }
  int style = 0;
  api_->getIntegerv(hd::kCalibrationStyle, &style);
  calibrationStyle_ = static_cast<hd::Name>(style);
  throwOnError("tell what it can do");
  capabilities_.check();
}

void PhantomDevice::throwOnError(const char* doing) const {
  const auto error = firstFailure(*api_);
  if (error.code == hd::kSuccess) return;
  const char* reason = api_->getErrorString(error.code);
  throw DeviceError(
      fmt::format("the Phantom device {}can't {}: {} (HD error 0x{:04X}, {}): is it plugged in, "
                  "switched on and set up with the vendor's tool?",
                  configuration_.empty() ? "" : "\"" + configuration_ + "\" ", doing,
                  reason != nullptr ? reason : "no reason given", error.code, error.internalCode));
}

/// A tick of HD's scheduler; false: the device is lost.
bool PhantomDevice::exchange() {
  if (api_->checkCalibration() == hd::kCalibrationNeedsUpdate) api_->updateCalibration(calibrationStyle_);
  std::array<double, 16> transform{};
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  int buttons = 0;
  api_->beginFrame(device_);
  api_->getDoublev(hd::kCurrentTransform, transform.data());
  api_->getDoublev(hd::kCurrentVelocity, velocity.data());
  api_->getIntegerv(hd::kCurrentButtons, &buttons);
  ticksSinceForce_ = forces_.take(force_) ? 0 : ticksSinceForce_ + 1;
  if (ticksSinceForce_ > kTicksAForceIsHeld) force_.setZero();
  api_->setDoublev(hd::kCurrentForce, force_.data());
  api_->endFrame(device_);
  if (firstFailure(*api_).code != hd::kSuccess) return false;

  for (const double each : transform)
    if (!std::isfinite(each)) return false;
  for (const double each : velocity)
    if (!std::isfinite(each)) return false;
  const Eigen::Matrix4d pose = Eigen::Map<const Eigen::Matrix4d>(transform.data());
  const Eigen::Quaterniond orientation(pose.topLeftCorner<3, 3>());
  if (const double norm = orientation.norm(); !(norm > 0.5 && norm < 2)) return false;  // no rotation
  states_.put({.position = (pose.topRightCorner<3, 1>() - origin_) * kMillimetre,
               .orientation = orientation.normalized(),
               .velocity = velocity * kMillimetre,
               .buttons = static_cast<std::uint32_t>(buttons)});
  return true;
}

hd::CallbackCode PhantomDevice::exchangeOnce(void* self) {
  static_cast<PhantomDevice*>(self)->exchange();
  return hd::kCallbackDone;
}

hd::CallbackCode PhantomDevice::exchangeEachTick(void* self) {
  auto& device = *static_cast<PhantomDevice*>(self);
  if (!device.isLost_ && device.exchange()) return hd::kCallbackContinue;
  device.isLost_ = true;
  // HD would go on giving the force that was set last.
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  device.api_->beginFrame(device.device_);
  device.api_->setDoublev(hd::kCurrentForce, none.data());
  device.api_->endFrame(device.device_);
  return hd::kCallbackDone;
}

bool PhantomDevice::read(double time, DeviceState& state) noexcept {
  if (states_.take(state_) || !lastNews_) lastNews_ = time;
  if (time - *lastNews_ > kLongestSilence) isLost_ = true;
  if (isLost_) return false;
  state = state_;
  return true;
}

bool PhantomDevice::write(const DeviceForce& force) noexcept {
  if (isLost_) return false;
  forces_.put(limited(force.force, capabilities_.maxForce));
  return true;
}

}  // namespace pleura::haptics
