#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <pleura/nodes/thorax/anatomy/implicit_surface.h>
#include <pleura/nodes/thorax/anatomy/measurements.h>
#include <pleura/nodes/thorax/anatomy/sternum.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

constexpr double kSternumSpacing = 0.0036;  // [m] triangle size
constexpr double kSternumSeam = 0.006;      // [m] width over which the three parts grow together

// A horizontal section: a super-ellipse bent so that its borders lie where they were measured.
struct Section {
  Vector3d centre;
  double halfWidth;
  double halfDepth;
  double bend;  // [m] how far the border lies in front of the centre
};

// Sections of one part, top down. The xiphoid was measured in another release: it is moved to the body's end.
std::vector<Section> sectionsOf(const Table& table, std::string_view part) {
  const Vector3d shift = part == "xiphoid" ? Vector3d(0.0, -0.015, -0.007) : Vector3d::Zero();
  std::vector<Section> sections;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text(row, "part") != part) continue;
    const double x = table.number(row, "centre_x_mm");
    const double y = table.number(row, "centre_y_mm");
    const double z = table.number(row, "z_mm");
    sections.push_back({fromTableFrame({x, y, z}) + shift, 1e-3 * table.number(row, "half_width_mm"),
                        0.5e-3 * table.number(row, "depth_horizontal_mm"),
                        1e-3 * (y - table.number(row, "edge_y_mm"))});
  }
  return sections;
}

Section sectionAt(const std::vector<Section>& sections, double y) {
  const auto below = std::find_if(sections.begin() + 1, sections.end() - 1,
                                  [&](const Section& s) { return s.centre.y() <= y; });
  const Section& p = *(below - 1);
  const Section& q = *below;
  const double t = std::clamp((p.centre.y() - y) / (p.centre.y() - q.centre.y()), 0.0, 1.0);
  return {p.centre + t * (q.centre - p.centre), p.halfWidth + t * (q.halfWidth - p.halfWidth),
          p.halfDepth + t * (q.halfDepth - p.halfDepth), p.bend + t * (q.bend - p.bend)};
}

// |x/w|^3 + |z/d|^3 <= 1: flatter than an ellipse, as the bone is.
double partOf(const std::vector<Section>& sections, const Vector3d& point) {
  const Section s = sectionAt(sections, point.y());
  const double x = std::abs(point.x() - s.centre.x()) / s.halfWidth;
  const double z = std::abs(point.z() - s.centre.z() - s.bend * x * x) / s.halfDepth;
  const double side = (std::cbrt(x * x * x + z * z * z) - 1.0) * std::min(s.halfWidth, s.halfDepth);
  const double top = point.y() - sections.front().centre.y();
  const double bottom = sections.back().centre.y() - point.y();
  return smoothIntersection(side, std::max(top, bottom), 0.004);
}

// The fibrocartilage between two parts: a flat cone from inside the one to inside the other.
double joint(const Vector3d& point, const Vector3d& above, const Vector3d& below, double halfWidth,
             double halfDepth) {
  const Vector3d flat(halfDepth / halfWidth, 1.0, 1.0);
  return roundCone(point.cwiseProduct(flat), above.cwiseProduct(flat), halfDepth, below.cwiseProduct(flat),
                   halfDepth);
}

}  // namespace

Sternum generateSternum() {
  const Table table = measurementTable("sternum");
  const auto manubrium = sectionsOf(table, "manubrium");
  const auto body = sectionsOf(table, "body");
  const auto xiphoid = sectionsOf(table, "xiphoid");
  const Vector3d top = manubrium.front().centre;
  const Vector3d notch = top + Vector3d(0.0, 0.011, 0.0);

  const Solid bone = [&](const Vector3d& p) {
    const double jugularNotch = 0.018 - std::hypot(p.x() - notch.x(), p.y() - notch.y());
    const double upper = smoothIntersection(partOf(manubrium, p), jugularNotch, 0.006);
    const double symphysis = joint(p, manubrium.end()[-2].centre, body[1].centre, 0.015, 0.007);
    const double xiphisternal = joint(p, body.end()[-2].centre, xiphoid[1].centre, 0.008, 0.0045);
    const double lower = smoothUnion(smoothUnion(partOf(body, p), xiphisternal, kSternumSeam),
                                     partOf(xiphoid, p), kSternumSeam);
    return smoothUnion(smoothUnion(upper, symphysis, kSternumSeam), lower, kSternumSeam);
  };
  Eigen::AlignedBox3d box(top);
  box.extend(body.back().centre).extend(xiphoid.back().centre);
  const Vector3d margin(0.035, 0.008, 0.025);
  Sternum sternum;
  sternum.mesh = skinOf(bone, {box.min() - margin, box.max() + margin}, kSternumSpacing);
  sternum.jugularNotch = Eigen::Vector3d(top + Vector3d(0.0, -0.007, -0.003)).cast<float>();
  sternum.sternalAngle = Eigen::Vector3d(0.5 * (manubrium.back().centre + body.front().centre)).cast<float>();
  sternum.xiphoidTip = xiphoid.back().centre.cast<float>();
  return sternum;
}

}  // namespace pleura
