#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <pleura/nodes/thorax/anatomy/implicit_surface.h>
#include <pleura/nodes/thorax/anatomy/measurements.h>
#include <pleura/nodes/thorax/anatomy/tube.h>
#include <pleura/nodes/thorax/anatomy/vertebrae.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

constexpr double kVertebraSpacing = 0.0028;  // [m] triangle size
constexpr double kVertebraSeam = 0.004;      // [m] width over which the parts grow together
constexpr double kCanalRadius = 0.008;       // [m] of the vertebral canal

// One vertebra as measured; its own frame is x to the left, y up its axis, z to the front, origin in the
// body.
struct Measured {
  Vector3d centre, spinous, transverse[2];  // transverse: left, right
  double halfWidth, halfDepth, halfHeight;
  Eigen::Matrix3d axes;  // columns: x, y, z of its own frame

  Vector3d toOwn(const Vector3d& p) const { return axes.transpose() * (p - centre); }
  Vector3d up() const { return axes.col(1); }
};

Measured measuredVertebra(const Table& table, std::size_t row) {
  Measured m;
  m.centre = table.point(row, "body_");
  m.halfWidth = 0.5e-3 * table.number(row, "body_width_mm");
  m.halfDepth = 0.5e-3 * table.number(row, "body_depth_mm");
  m.halfHeight = 0.5e-3 * table.number(row, "body_height_mm");
  const Vector3d up = table.direction(row, "up_");
  const Vector3d front = Vector3d::UnitX().cross(up).normalized();
  m.axes << up.cross(front), up, front;
  m.spinous = m.toOwn(table.point(row, "spinous_"));
  m.transverse[0] = m.toOwn(table.point(row, "transverse_left_"));
  m.transverse[1] = m.toOwn(table.point(row, "transverse_right_"));
  return m;
}

// A cylinder of elliptic section with a waist of a tenth of its radius.
double body(const Measured& m, const Vector3d& p) {
  const double h = p.y() / m.halfHeight;
  const double waist = 1.0 - 0.1 * std::max(0.0, 1.0 - h * h);
  const double rho = std::hypot(p.x() / m.halfWidth, p.z() / m.halfDepth);
  const double side = (rho - waist) * std::min(m.halfWidth, m.halfDepth);
  return smoothIntersection(side, std::abs(p.y()) - m.halfHeight, 0.003);
}

// The half of the arch on one side: pedicle, lamina, articular processes, transverse process.
double halfArch(const Measured& m, const Vector3d& p, double side, const Vector3d& transverseTip) {
  const double canal = -m.halfDepth - kCanalRadius + 0.001;  // z of the canal's axis
  const Vector3d root(side * 0.010, 0.35 * m.halfHeight, -0.8 * m.halfDepth);
  const Vector3d pillar(side * 0.0125, 0.25 * m.halfHeight, canal - 0.005);
  const Vector3d spine(0.0, -0.1 * m.halfHeight, canal - kCanalRadius - 0.003);
  const Vector3d above = pillar + Vector3d(0.0, 0.95 * m.halfHeight, 0.001);
  const Vector3d below = pillar + Vector3d(-side * 0.002, -1.25 * m.halfHeight, -0.003);
  double arch = roundCone(p, root, 0.0050, pillar, 0.0050);
  arch = smoothUnion(arch, roundCone(p, pillar, 0.0048, spine, 0.0042), kVertebraSeam);
  arch = smoothUnion(arch, roundCone(p, pillar, 0.0048, above, 0.0038), kVertebraSeam);
  arch = smoothUnion(arch, roundCone(p, pillar, 0.0048, below, 0.0038), kVertebraSeam);
  const Vector3d tip = transverseTip - 0.0055 * (transverseTip - pillar).normalized();
  return smoothUnion(arch, roundCone(p, pillar, 0.0045, tip, 0.0055), kVertebraSeam);
}

// A blade from the arch to the measured tip: thin from side to side, tall at its root.
double spinousProcess(const Measured& m, const Vector3d& p) {
  constexpr double kFlat = 1.7;
  const Vector3d root(0.0, -0.15 * m.halfHeight, -m.halfDepth - 2.0 * kCanalRadius - 0.003);
  const Vector3d tip = m.spinous - 0.0045 * (m.spinous - root).normalized();
  const Vector3d flat(kFlat, 1.0, 1.0);
  return roundCone(p.cwiseProduct(flat), root.cwiseProduct(flat), 0.0075, tip.cwiseProduct(flat), 0.0048) /
         kFlat;
}

TriangleMesh bone(const Measured& m) {
  const Solid solid = [&](const Vector3d& scenePoint) {
    const Vector3d p = m.toOwn(scenePoint);
    const double arch = smoothUnion(halfArch(m, p, 1.0, m.transverse[0]),
                                    halfArch(m, p, -1.0, m.transverse[1]), kVertebraSeam);
    return smoothUnion(body(m, p), smoothUnion(arch, spinousProcess(m, p), kVertebraSeam), kVertebraSeam);
  };
  Eigen::AlignedBox3d box(m.centre);
  for (const Vector3d& tip : {m.spinous, m.transverse[0], m.transverse[1]})
    box.extend(m.centre + m.axes * tip);
  const Vector3d margin = Vector3d::Constant(0.006) + Vector3d(0.0, 1.0, 1.0) * 2.0 * m.halfHeight;
  return skinOf(solid, {box.min() - margin, box.max() + margin}, kVertebraSpacing);
}

// From end plate to end plate, a tenth wider than the waist of the bodies it joins.
TriangleMesh discBelow(const Measured& above, const Vector3d& bottom, double halfWidth, double halfDepth,
                       const Vector3d& bottomUp) {
  constexpr double kEmbedded = 0.001;  // [m] into either bone
  const Vector3d top = above.centre - (above.halfHeight - kEmbedded) * above.up();
  const Vector3d low = bottom - kEmbedded * bottomUp;
  const Vector3d lateral = above.axes.col(0);
  return tubeMesh(Tube({{0.0, low, halfWidth, halfDepth, lateral},
                        {1.0, top, above.halfWidth, above.halfDepth, lateral}}),
                  4, 28);
}

TriangleMesh disc(const std::vector<Measured>& spine, std::size_t i, const Vector3d& discCentre) {
  const Measured& above = spine[i];
  if (i + 1 == spine.size()) {
    const Vector3d bottom = 2.0 * discCentre - (above.centre - above.halfHeight * above.up());
    return discBelow(above, bottom, above.halfWidth, above.halfDepth, above.up());
  }
  const Measured& below = spine[i + 1];
  return discBelow(above, below.centre + below.halfHeight * below.up(), below.halfWidth, below.halfDepth,
                   below.up());
}

}  // namespace

std::vector<Vertebra> generateVertebrae() {
  const Table table = measurementTable("vertebrae");
  std::vector<Measured> spine;
  for (std::size_t row = 0; row < table.rows(); ++row) spine.push_back(measuredVertebra(table, row));
  std::vector<Vertebra> vertebrae;
  for (std::size_t i = 0; i < spine.size(); ++i) {
    Vertebra v;
    v.name = table.text(i, "vertebra");
    v.bone = bone(spine[i]);
    v.disc = disc(spine, i, table.point(i, "disc_below_"));
    v.bodyCentre = spine[i].centre.cast<float>();
    v.up = spine[i].up().cast<float>();
    v.spinousTip = table.point(i, "spinous_").cast<float>();
    v.transverseTipLeft = table.point(i, "transverse_left_").cast<float>();
    v.transverseTipRight = table.point(i, "transverse_right_").cast<float>();
    vertebrae.push_back(std::move(v));
  }
  return vertebrae;
}

}  // namespace pleura
