#include <cmath>
#include <numbers>

#include <pleura/nodes/standard/geometry3d/revolved_surface.h>

namespace pleura {

namespace {

constexpr std::uint32_t kSectors = 32;

}  // namespace

void addRevolved(std::span<const ProfilePoint> profile, RenderMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const ProfilePoint& p : profile)
    for (std::uint32_t i = 0; i <= kSectors; ++i) {
      const double angle = 2 * std::numbers::pi * (i % kSectors) / kSectors;
      const auto s = static_cast<float>(std::sin(angle));
      const auto c = static_cast<float>(std::cos(angle));
      mesh.positions.emplace_back(p.radius * s, p.y, p.radius * c);
      mesh.normals.emplace_back(p.normalRadius * s, p.normalY, p.normalRadius * c);
    }
  for (std::uint32_t row = 0; row + 1 < profile.size(); ++row)
    for (std::uint32_t i = 0; i < kSectors; ++i) {
      const std::uint32_t top = first + row * (kSectors + 1) + i;
      const std::uint32_t bottom = top + kSectors + 1;
      if (profile[row].radius > 0) mesh.indices.insert(mesh.indices.end(), {top, bottom, top + 1});
      if (profile[row + 1].radius > 0) mesh.indices.insert(mesh.indices.end(), {top + 1, bottom, bottom + 1});
    }
}

void startPrimitive(RenderMesh& mesh, bool solid) {
  mesh.positions.clear();
  mesh.normals.clear();
  mesh.indices.clear();
  mesh.solid = solid;
  ++mesh.topologyRevision;
  ++mesh.vertexRevision;
}

}  // namespace pleura
