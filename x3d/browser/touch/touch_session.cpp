#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <pleura/haptics/recorded/recording_device.h>
#include <pleura/haptics/simulated/stylus_path_csv.h>
#include <pleura/haptics/standard_drivers.h>
#include <pleura/nodes/haptic/simulated_device.h>
#include <pleura/nodes/standard/navigation/x3d_viewpoint_node.h>
#include <pleura/x3d/browser/touch/touch_session.h>
#include <pleura/x3d/browser/touch/workspace.h>

namespace pleura {

namespace {

constexpr double kRetry = 1;  // [s] between attempts to open a device that is not there

constexpr double kLongestJump = 10;  // [s] that haptic ticks are made up for

/// Throws std::invalid_argument for a driver that there is not.
void checkDriver(const std::string& driver) {
  try {
    haptics::standardDrivers().check(driver);
  } catch (const haptics::DeviceError& unknown) {
    throw std::invalid_argument(unknown.what());
  }
}

/// A device for a scene that has none, under the name that scenes share.
DeviceInfo& addDevice(Scene& scene) {
  const auto device = create<SimulatedDevice>();
  const auto info = create<DeviceInfo>();
  info->device.push_back(device, info->id);
  device->initialize(scene);
  info->initialize(scene);
  if (scene.document().names.try_emplace("STYLUS", device).second) device->setName("STYLUS");
  scene.document().nodes.push_back(info);
  return *info;
}

}  // namespace

/// A device with its node and its loop.
struct TouchSession::Hand {
  HapticsDeviceNode* node = nullptr;
  std::vector<std::string> drivers;
  TouchOptions asked;                              // empty but for the first
  std::vector<haptics::StylusWaypoint> waypoints;  // asked for; none: the scene's
  std::unique_ptr<haptics::HapticDevice> device;   // null until it was opened once
  haptics::RecordingDevice* recording = nullptr;   // `device`, when it is recorded
  std::unique_ptr<haptics::Servo> servo;           // null while the device is not open
  std::unique_ptr<haptics::ServoLoop> loop;        // only on the real clock
  std::int64_t ticks = 0;                          // on the virtual clock
  Time tried = 0;                                  // to open it
  Time rateSince = 0;
  std::int64_t rateTicks = 0;
};

TouchSession::TouchSession(Scene& scene, const TouchOptions& options, Clock clock)
    : scene_(scene), clock_(clock), touchScene_(scene) {
  adopt(options);
}

TouchSession::~TouchSession() {
  for (auto& hand : hands_) {
    hand->loop.reset();
    if (hand->device) hand->device->close();
  }
}

void TouchSession::adopt(const TouchOptions& options) {
  const bool isAsked = !options.isEmpty();
  auto* info = dynamic_cast<DeviceInfo*>(scene_.bindables("DeviceInfo").top());
  if (isAsked && (info == nullptr || info->device.empty())) info = &addDevice(scene_);
  if (info == nullptr) return;
  for (const auto& node : info->device.getValue()) {
    hands_.push_back(std::make_unique<Hand>());
    hands_.back()->node = dynamic_cast<HapticsDeviceNode*>(node.get());
    hands_.back()->drivers = hands_.back()->node->drivers();
    devices_.push_back(node);
  }
  if (!isAsked) return;
  Hand& first = *hands_.front();
  first.asked = options;
  if (!options.device.empty()) {
    checkDriver(options.device);
    first.drivers = {options.device};
  } else if (!options.stylus.empty() && first.drivers.front() != "recorded") {
    first.drivers = {"simulated"};
  }
  if (first.drivers.front() == "simulated" && !options.stylus.empty())
    first.waypoints = haptics::readStylusPath(options.stylus).waypoints();
}

haptics::DeviceSettings TouchSession::settingsOf(Hand& hand) const {
  haptics::DeviceSettings settings = hand.node->settings();
  if (!hand.asked.stylus.empty()) {
    settings.file = hand.asked.stylus;
  } else if (const std::string file = hand.node->file(); !file.empty()) {
    settings.file = scene_.fileOf(file);
  }
  if (!hand.waypoints.empty()) {
    settings.file.clear();
    settings.waypoints = hand.waypoints;
  }
  return settings;
}

void TouchSession::open() {
  for (auto& hand : hands_) hand->asked.isEmpty() ? tryToOpen(*hand, 0) : open(*hand, 0);
}

void TouchSession::tryToOpen(Hand& hand, Time now) {
  try {
    open(hand, now);
  } catch (const std::runtime_error& problem) {
    scene_.warn(*hand.node, problem.what());
  }
}

void TouchSession::open(Hand& hand, Time now) {
  hand.tried = now;
  hand.device ? hand.device->open() : openFirst(hand);
  const auto& can = hand.device->capabilities();
  hand.node->inputDOF.setValueIfChanged(can.inputDof, hand.node->id);
  hand.node->outputDOF.setValueIfChanged(can.outputDof, hand.node->id);
  const double rate = hand.node->desiredHapticsRate.getValue(hand.node->id);
  hand.servo = std::make_unique<haptics::Servo>(*hand.device, 1 / rate);
  hand.ticks = static_cast<std::int64_t>(std::ceil(now * rate - 1e-9));
  hand.rateSince = now;
  hand.rateTicks = 0;
}

/// The first driver that opens serves from then on: a device that was lost is the same when it is back.
void TouchSession::openFirst(Hand& hand) {
  const haptics::DeviceSettings settings = settingsOf(hand);
  std::string problems;
  for (const auto& driver : hand.drivers) {
    try {
      auto device = haptics::standardDrivers().make(driver, settings);
      haptics::RecordingDevice* recording = nullptr;
      if (!hand.asked.record.empty()) {
        auto recorded = std::make_unique<haptics::RecordingDevice>(std::move(device), hand.asked.record);
        recording = recorded.get();
        device = std::move(recorded);
      }
      device->open();
      hand.device = std::move(device);
      hand.recording = recording;
      return;
    } catch (const haptics::DeviceError& bad) {
      problems += (problems.empty() ? "" : "; ") + std::string(bad.what());
    }
  }
  throw haptics::DeviceError(problems);
}

void TouchSession::lose(Hand& hand, Time now) {
  hand.loop.reset();
  hand.servo.reset();
  hand.device->close();
  hand.tried = now;
  scene_.warn(*hand.node, "the device is lost; it is tried again every second");
}

void TouchSession::advance(Time now) {
  if (hands_.empty()) return;
  touchScene_.update();
  const double duration = isFirst_ ? 0 : now - last_;
  for (std::size_t k = 0; k < hands_.size(); ++k) {
    Hand& hand = *hands_[k];
    if (!hand.servo && now - hand.tried >= kRetry) tryToOpen(hand, now);
    if (!hand.servo) continue;
    publish(hand, duration);
    if (clock_ == Clock::virtualTime) {
      const double period = hand.servo->period();
      constexpr double kRounding = 1e-9;
      // A scene that jumps far ahead is not waited for: the hand was elsewhere meanwhile.
      const auto first = static_cast<std::int64_t>(std::ceil((now - kLongestJump) / period));
      hand.ticks = std::max(hand.ticks, first);
      for (; static_cast<double>(hand.ticks) * period <= now + kRounding; ++hand.ticks, ++hand.rateTicks)
        hand.servo->tick(static_cast<double>(hand.ticks) * period);
    } else if (!hand.loop) {
      hand.loop = std::make_unique<haptics::ServoLoop>(*hand.servo, now, true);
    }
    if (hand.recording != nullptr) hand.recording->flush();
    hear(hand, k, now);
  }
  last_ = now;
  isFirst_ = false;
}

void TouchSession::publish(Hand& hand, double duration) {
  haptics::TouchFrame& frame = hand.servo->frames().back();
  HapticsDeviceNode& node = *hand.node;
  frame.duration = duration;
  frame.workspace = workspaceOf(node, dynamic_cast<X3DViewpointNode*>(scene_.bindables("Viewpoint").top()),
                                touchScene_.viewpointToWorld());
  frame.tipRadius = node.proxyRadius.getValue();
  frame.forceLimit = node.forceLimit.getValue();
  frame.deadmansSwitch = node.deadmansSwitch.getValue();
  touchScene_.fill(frame, hand.servo->stiffnessLimit(), hand.servo->dampingLimit());
  hand.servo->frames().publish();
}

void TouchSession::hear(Hand& hand, std::size_t index, Time now) {
  if (!hand.servo->reports().take()) return;
  const haptics::ServoReport& report = hand.servo->reports().taken();
  HapticsDeviceNode& node = *hand.node;
  setOutputs(node, report, touchedBy(report));
  tellParts(report, index);
  for (int k = 0; k < report.effectCount; ++k)
    if (const auto place = static_cast<std::size_t>(k); place < touchScene_.effects().size())
      touchScene_.effects()[place].node->report(report.effectForces[place].cast<float>(),
                                                report.isEffectActive[place]);
  if (hand.loop) node.hapticsLoopTime.setValue(hand.loop->lastDuration(), node.id);
  if (now - hand.rateSince >= 1) {
    const std::int64_t ticks = hand.loop ? hand.loop->periods().count() - hand.rateTicks : hand.rateTicks;
    node.hapticsRate.setValueIfChanged(
        static_cast<int>(std::lround(static_cast<double>(ticks) / (now - hand.rateSince))), node.id);
    hand.rateTicks = hand.loop ? hand.loop->periods().count() : 0;
    hand.rateSince = now;
  }
  if (!report.isConnected) lose(hand, now);
}

TouchedPart TouchSession::touchedBy(const haptics::ServoReport& report) const {
  TouchedPart touched;
  double deepest = -1;
  for (int k = 0; k < report.contactCount; ++k) {
    const auto& contact = report.contacts[static_cast<std::size_t>(k)];
    const auto& part = touchScene_.parts()[contact.shape];
    if (part.geometry == nullptr) continue;
    if (part.givesWay()) touched.givenWay -= contact.depth * contact.normal;
    if (contact.depth <= deepest) continue;
    deepest = contact.depth;
    touched.called = part.called;
  }
  return touched;
}

void TouchSession::tellParts(const haptics::ServoReport& report, std::size_t index) {
  const auto& parts = touchScene_.parts();
  isTold_.resize(parts.size() * hands_.size());
  for (std::size_t id = 0; id < parts.size(); ++id) {
    const haptics::ServoReport::Contact* deepest = nullptr;
    for (int k = 0; k < report.contactCount; ++k) {
      const auto& contact = report.contacts[static_cast<std::size_t>(k)];
      if (contact.shape == id && (deepest == nullptr || contact.depth > deepest->depth)) deepest = &contact;
    }
    const auto told = static_cast<std::ptrdiff_t>(index * parts.size() + id);
    const TouchScene::Part& part = parts[id];
    if (part.geometry == nullptr || (deepest == nullptr && !isTold_[static_cast<std::size_t>(told)]))
      continue;
    isTold_[static_cast<std::size_t>(told)] = deepest != nullptr;
    setOutputs(part, deepest, report.force, index, hands_.size());
  }
}

TouchSession::Statistics TouchSession::statistics() const {
  Statistics told;
  told.treesBuilt = touchScene_.builds();
  told.treesRefitted = touchScene_.refits();
  if (hands_.empty()) return told;
  const Hand& hand = *hands_.front();
  told.ticks = hand.ticks;
  if (!hand.loop) return told;
  const auto& periods = hand.loop->periods();
  told.ticks = periods.count();
  told.missed = periods.missed();
  told.p50 = periods.quantile(0.5);
  told.p99 = periods.quantile(0.99);
  told.p999 = periods.quantile(0.999);
  told.longest = periods.longest();
  return told;
}

}  // namespace pleura
