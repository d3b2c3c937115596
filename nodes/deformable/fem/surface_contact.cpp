#include <algorithm>
#include <cassert>
#include <vector>

#include <pleura/nodes/deformable/fem/surface_contact.h>

namespace pleura {

using Eigen::Vector3d;

int addContactForces(const ContactWall& wall, double stiffness, std::span<const Vector3d> points,
                     std::span<Vector3d> forces) {
  assert(wall.places.size() == points.size() && wall.normals.size() == points.size());
  assert(forces.size() == points.size());
  int contacts = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double gap = wall.gap(i, points[i]);
    if (gap >= 0) continue;
    forces[i] += stiffness * gap * wall.normals[i];
    ++contacts;
  }
  return contacts;
}

int updateActive(const ContactWall& wall, std::span<const Vector3d> points, std::span<char> active) {
  assert(wall.places.size() == points.size() && wall.normals.size() == points.size());
  assert(active.size() == points.size());
  int changes = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const char now = wall.gap(i, points[i]) < 0 ? 1 : 0;
    changes += now != active[i] ? 1 : 0;
    active[i] = now;
  }
  return changes;
}

ContactRows contactRows(const ContactWall& wall, const Embedding& embedding, std::span<const char> active) {
  assert(std::ssize(active) == embedding.size());
  const auto count = std::ranges::count_if(active, [](char flag) { return flag != 0; });
  ContactRows result{{count, 3 * Eigen::Index{embedding.nodeCount}}, Eigen::VectorXd(count)};
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(24 * static_cast<std::size_t>(count));
  int row = 0;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (active[i] == 0) continue;
    for (std::size_t k = 8 * i; k < 8 * (i + 1); ++k)
      for (int axis = 0; axis < 3; ++axis)
        entries.emplace_back(row, 3 * embedding.nodes[k] + axis,
                             embedding.weights[k] * wall.normals[i][axis]);
    result.values[row++] = wall.normals[i].dot(wall.places[i]);
  }
  result.rows.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace pleura
