#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <pleura/nodes/thorax/motion/pleural_wall.h>

namespace pleura {
namespace {

constexpr double kRollingCurvature = 4.0;  // [1/rad^2] bridges an intercostal space with a sagitta under 1 mm
constexpr double kBelowMargin = 0.05;      // [m] the profile goes on straight below the last bone
constexpr std::size_t kFewestPoints = 24;

/// A point of a bone in the half-plane of a column.
struct ProfilePoint {
  double h = 0.0;  // height along the axis [m]
  double r = 0.0;  // distance from the axis [m]
  BodyWeights weights;
};

using Profile = std::vector<ProfilePoint>;

/// Signed distance to the plane of a column and position within it.
struct PlanePoint {
  double across, r, h;
};

PlanePoint inPlane(const HemithoraxAxis& axis, const Eigen::Vector3d& radial, const Eigen::Vector3d& normal,
                   const Eigen::Vector3f& point) {
  const Eigen::Vector3d p = point.cast<double>() - axis.origin;
  return {p.dot(normal), p.dot(radial), p.dot(axis.up)};
}

/// Where the edges of a bone's triangles pierce the half-plane below the cupola.
void addSection(const HemithoraxAxis& axis, double azimuth, double cupola, const WallBody& body,
                Profile& profile) {
  const Eigen::Vector3d radial = axis.radial(azimuth);
  const Eigen::Vector3d normal = axis.up.cross(radial);
  for (const Eigen::Vector3i& triangle : body.mesh->triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(triangle[k]);
      const auto j = static_cast<std::size_t>(triangle[(k + 1) % 3]);
      const PlanePoint a = inPlane(axis, radial, normal, body.mesh->points[i]);
      const PlanePoint b = inPlane(axis, radial, normal, body.mesh->points[j]);
      if ((a.across < 0.0) == (b.across < 0.0)) continue;
      const double t = a.across / (a.across - b.across);
      const double r = (1.0 - t) * a.r + t * b.r;
      const double h = (1.0 - t) * a.h + t * b.h;
      if (r > 0.0 && h < cupola) profile.push_back({h, r, mix(body.weights[i], body.weights[j], t)});
    }
  }
}

/// (phi, u): elevation seen from the axis' origin [rad] and logarithm of the distance. This map keeps angles,
/// so that a curve of one shape fits the steep lower wall as well as the shoulder under the cupola.
struct LogPolar {
  double phi, u;
};

LogPolar logPolar(const ProfilePoint& p) { return {std::atan2(p.h, p.r), std::log(std::hypot(p.h, p.r))}; }

// f(phi) = u + k phi^2 / 2
double lifted(const LogPolar& p) { return p.u + 0.5 * kRollingCurvature * p.phi * p.phi; }

/// Lower convex hull of (phi, f), from the top down (Andrew's monotone chain).
Profile innerEnvelope(Profile points) {
  std::sort(points.begin(), points.end(),
            [](const ProfilePoint& a, const ProfilePoint& b) { return logPolar(a).phi > logPolar(b).phi; });
  Profile hull;
  for (const ProfilePoint& p : points) {
    const LogPolar c = logPolar(p);
    while (hull.size() >= 2) {
      const LogPolar b = logPolar(hull[hull.size() - 1]);
      const LogPolar a = logPolar(hull[hull.size() - 2]);
      const double turn =
          (a.phi - b.phi) * (lifted(c) - lifted(b)) - (b.phi - c.phi) * (lifted(b) - lifted(a));
      if (turn > 0.0) break;
      hull.pop_back();
    }
    hull.push_back(p);
  }
  return hull;
}

double length(const Profile& profile) {
  double sum = 0.0;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    sum += std::hypot(profile[i].h - profile[i - 1].h, profile[i].r - profile[i - 1].r);
  }
  return sum;
}

/// kRows points at equal distances along the profile.
Profile resampled(const Profile& profile, double spacing) {
  Profile rows{profile.front()};
  double passed = 0.0;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    const ProfilePoint& a = profile[i - 1];
    const ProfilePoint& b = profile[i];
    const double step = std::hypot(b.h - a.h, b.r - a.r);
    while (rows.size() < PleuralWall::kRows && static_cast<double>(rows.size()) * spacing <= passed + step) {
      const double t = (static_cast<double>(rows.size()) * spacing - passed) / step;
      rows.push_back({(1.0 - t) * a.h + t * b.h, (1.0 - t) * a.r + t * b.r, mix(a.weights, b.weights, t)});
    }
    passed += step;
  }
  while (rows.size() < PleuralWall::kRows) rows.push_back(profile.back());
  return rows;
}

void setColumn(PleuralWall& wall, int column, const Profile& rows, double azimuth) {
  const Eigen::Vector3d radial = wall.axis.radial(azimuth);
  for (int row = 0; row < PleuralWall::kRows; ++row) {
    const ProfilePoint& p = rows[static_cast<std::size_t>(row)];
    const Eigen::Vector3d point = wall.axis.origin + p.r * radial + p.h * wall.axis.up;
    wall.rest[PleuralWall::index(column, row)] = point.cast<float>().homogeneous();
    wall.weights[PleuralWall::index(column, row)] = p.weights;
  }
}

/// The point of a column at a distance down from the cupola [m], within its ends.
Eigen::Vector3f below(const PleuralWall& wall, int column, double distance) {
  const double row = distance / wall.spacing[static_cast<std::size_t>(column)];
  const double inside = std::clamp(row, 0.0, PleuralWall::kRows - 1.0);
  const int whole = std::min(static_cast<int>(inside), PleuralWall::kRows - 2);
  const std::size_t above = PleuralWall::index(column, whole);
  const auto t = static_cast<float>(inside - whole);
  return ((1.0f - t) * wall.rest[above] + t * wall.rest[above + 1]).head<3>();
}

/// Inward unit normal from differences between the rows and, at the same distance from the cupola, between
/// the columns beside; one-sided at the grid's borders.
Eigen::Vector3f normalAt(const PleuralWall& wall, int column, int row) {
  const double spacing = wall.spacing[static_cast<std::size_t>(column)];
  const auto at = [&](int c, int r) { return below(wall, wall.open(c) ? column : c, r * spacing); };
  const Eigen::Vector3f around = at(PleuralWall::next(column), row) - at(PleuralWall::previous(column), row);
  const Eigen::Vector3f normal = (at(column, row + 1) - at(column, row - 1)).cross(around);
  const Eigen::Vector3f up = wall.axis.up.cast<float>();
  if (!(normal.norm() > 0.0f)) return -up;  // the pole
  const Eigen::Vector3f out = at(column, row) - wall.axis.origin.cast<float>();
  return normal.dot(out) > 0.0f ? -normal.normalized() : normal.normalized();
}

void setNormals(PleuralWall& wall) {
  for (int column = 0; column < PleuralWall::kColumns; ++column) {
    if (wall.open(column)) continue;
    for (int row = 0; row < PleuralWall::kRows; ++row) {
      wall.inward[PleuralWall::index(column, row)].head<3>() = normalAt(wall, column, row);
    }
  }
}

}  // namespace

HemithoraxAxis::Coordinates HemithoraxAxis::coordinates(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = point - origin;
  const double a = p.dot(lateral);
  const double b = p.dot(front);
  return {std::atan2(b, a), std::hypot(a, b), p.dot(up)};
}

Eigen::Vector3d HemithoraxAxis::radial(double azimuth) const {
  return std::cos(azimuth) * lateral + std::sin(azimuth) * front;
}

HemithoraxAxis hemithoraxAxis(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double side) {
  if (!low.array().isFinite().all() || !high.array().isFinite().all() || !((high - low).norm() > 0.0)) {
    throw std::invalid_argument("hemithoraxAxis: low and high must be finite and apart");
  }
  if (side != 1.0 && side != -1.0) throw std::invalid_argument("hemithoraxAxis: side must be +1 or -1");
  HemithoraxAxis axis;
  axis.origin = 0.5 * (low + high);
  axis.up = (high - low).normalized();
  axis.front = (Eigen::Vector3d::UnitZ() - axis.up.z() * axis.up).normalized();
  axis.lateral = side * axis.up.cross(axis.front);
  return axis;
}

PleuralWall buildPleuralWall(const HemithoraxAxis& axis, std::span<const WallBody> bodies, double cupola) {
  for (const WallBody& body : bodies) {
    if (body.weights.size() != body.mesh->points.size()) {
      throw std::invalid_argument("buildPleuralWall: bodies need one weight a point");
    }
  }
  PleuralWall wall;
  wall.axis = axis;
  wall.spacing.assign(PleuralWall::kColumns, 0.0);
  wall.rest.assign(std::size_t{PleuralWall::kColumns} * PleuralWall::kRows,
                   axis.origin.cast<float>().homogeneous());
  wall.inward.assign(wall.rest.size(), Eigen::Vector4f::Zero());
  wall.weights.resize(wall.rest.size());
  for (int column = 0; column < PleuralWall::kColumns; ++column) {
    const double azimuth = -std::numbers::pi + 2.0 * std::numbers::pi * column / PleuralWall::kColumns;
    Profile section;
    for (const WallBody& body : bodies) addSection(axis, azimuth, cupola, body, section);
    if (section.size() < kFewestPoints) continue;
    section.push_back({cupola, 0.0, {}});
    Profile profile = innerEnvelope(std::move(section));
    profile.push_back(profile.back());
    profile.back().h -= kBelowMargin;
    const double spacing = length(profile) / (PleuralWall::kRows - 1);
    wall.spacing[static_cast<std::size_t>(column)] = spacing;
    setColumn(wall, column, resampled(profile, spacing), azimuth);
  }
  setNormals(wall);
  return wall;
}

std::vector<Eigen::Vector3i> wallTriangles(const PleuralWall& wall) {
  std::vector<Eigen::Vector3i> triangles;
  const bool left = wall.axis.lateral.x() > 0.0;  // the sense of azimuth mirrors with the side
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const Eigen::Vector3i t(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c));
    triangles.push_back(left ? Eigen::Vector3i(t[0], t[2], t[1]) : t);
  };
  for (int c = 0; c < PleuralWall::kColumns; ++c) {
    const int d = PleuralWall::next(c);
    if (wall.open(c) || wall.open(d)) continue;
    for (int r = 0; r + 1 < PleuralWall::kRows; ++r) {
      add(PleuralWall::index(c, r), PleuralWall::index(d, r), PleuralWall::index(c, r + 1));
      add(PleuralWall::index(d, r), PleuralWall::index(d, r + 1), PleuralWall::index(c, r + 1));
    }
  }
  return triangles;
}

void moveWall(const PleuralWall& wall, std::span<const BodyDisplacement> displacements,
              std::span<Eigen::Vector4f> now) {
  for (std::size_t k = 0; k < wall.rest.size(); ++k)
    now[k] = carry(wall.rest[k], wall.weights[k], displacements);
}

}  // namespace pleura
