#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <pleura/haptics/simulated/stylus_path.h>

namespace pleura::haptics {

namespace {

constexpr double kFarthest = 10;        // [m]: who writes millimetres learns it here
constexpr double kLatest = 1e9;         // [s]
constexpr double kShortestStep = 1e-6;  // [s]: bounds the hand's speed
constexpr double kShortest = 1e-6;      // of a quaternion whose direction can be trusted

bool isWithin(double value, double bound) { return std::isfinite(value) && std::abs(value) <= bound; }

}  // namespace

StylusPath::StylusPath() : waypoints_(1) {}

StylusPath::StylusPath(std::vector<StylusWaypoint> waypoints) : waypoints_(std::move(waypoints)) {
  if (waypoints_.empty()) throw DeviceError("the path of a stylus needs a waypoint, found none");
  const StylusWaypoint* previous = nullptr;
  for (auto& waypoint : waypoints_) {
    if (const auto found = fault(waypoint, previous); !found.empty())
      throw DeviceError(fmt::format("waypoint {} of a stylus: {}", &waypoint - waypoints_.data() + 1, found));
    waypoint.orientation.normalize();
    previous = &waypoint;
  }
}

std::string StylusPath::fault(const StylusWaypoint& waypoint, const StylusWaypoint* previous) {
  if (!isWithin(waypoint.time, kLatest))
    return fmt::format("expected a time within {:g} s, found {}", kLatest, waypoint.time);
  if (previous != nullptr && waypoint.time < previous->time + kShortestStep)
    return fmt::format("expected a time after {} s, found {}: time goes forwards by a microsecond at least",
                       previous->time, waypoint.time);
  for (const double coordinate : waypoint.position)
    if (!isWithin(coordinate, kFarthest))
      return fmt::format("expected a position in metres, within {:g} m, found {}", kFarthest, coordinate);
  for (const double component : waypoint.orientation.coeffs())
    if (!isWithin(component, 1e9)) return fmt::format("expected a quaternion, found {} in it", component);
  if (waypoint.orientation.norm() < kShortest)
    return "expected an orientation, found a quaternion of length 0";
  return {};
}

StylusPath::Span StylusPath::span(double time) const {
  const auto later = std::upper_bound(waypoints_.begin(), waypoints_.end(), time,
                                      [](double t, const StylusWaypoint& each) { return t < each.time; });
  if (later == waypoints_.begin()) return {waypoints_.front(), waypoints_.front(), 0};
  const auto& from = *(later - 1);
  if (later == waypoints_.end()) return {from, from, 0};
  return {from, *later, (time - from.time) / (later->time - from.time)};
}

Eigen::Vector3d StylusPath::position(double time) const {
  const auto [from, to, s] = span(time);
  return (1 - s) * from.position + s * to.position;
}

Eigen::Quaterniond StylusPath::orientation(double time) const {
  const auto [from, to, s] = span(time);
  return from.orientation.slerp(s, to.orientation);
}

std::uint32_t StylusPath::buttons(double time) const { return span(time).from.buttons; }

}  // namespace pleura::haptics
