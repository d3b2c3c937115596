#include <algorithm>
#include <cmath>
#include <limits>

#include <pleura/nodes/thorax/anatomy/lung_sections.h>
#include <pleura/nodes/thorax/anatomy/measurements.h>

namespace pleura {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double squaredDistanceToSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d axis = b - a;
  const double t = std::clamp((p - a).dot(axis) / std::max(axis.squaredNorm(), 1e-18), 0.0, 1.0);
  return (p - a - t * axis).squaredNorm();
}

// Does a ray from p towards +x cross the segment from a to b?
bool crosses(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  if ((a.y() > p.y()) == (b.y() > p.y())) return false;
  return p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
}

}  // namespace

LungSections::LungSections(Side side) {
  const Table table = measurementTable("lungs");
  int lastSection = -1;
  int lastLoop = -1;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text(row, "lung") != (side == Side::Left ? "left" : "right")) continue;
    const Vector3d point =
        fromTableFrame({table.number(row, "x_mm"), table.number(row, "y_mm"), table.number(row, "z_mm")});
    const int section = table.integer(row, "section");
    const int loop = table.integer(row, "loop");
    if (section != lastSection) sections_.push_back({point.y(), {}});
    if (section != lastSection || loop != lastLoop) sections_.back().outlines.emplace_back();
    sections_.back().outlines.back().emplace_back(point.x(), point.z());
    lastSection = section;
    lastLoop = loop;
  }
}

double LungSections::distance(const Section& section, const Vector2d& point) {
  double nearest = std::numeric_limits<double>::max();
  bool inside = false;
  for (const Outline& outline : section.outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector2d& a = outline[i];
      const Vector2d& b = outline[(i + 1) % outline.size()];
      nearest = std::min(nearest, squaredDistanceToSegment(point, a, b));
      inside ^= crosses(point, a, b);
    }
  }
  return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

double LungSections::distance(const Vector3d& point) const {
  const Vector2d plan(point.x(), point.z());
  const auto above = std::find_if(sections_.begin() + 1, sections_.end() - 1,
                                  [&](const Section& s) { return s.height >= point.y(); });
  const Section& low = *(above - 1);
  const Section& high = *above;
  const double t = std::clamp((point.y() - low.height) / (high.height - low.height), 0.0, 1.0);
  const double side = (1.0 - t) * distance(low, plan) + t * distance(high, plan);
  return std::max(side, point.y() - sections_.back().height);
}

}  // namespace pleura
