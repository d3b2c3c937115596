#pragma once

#include <span>

#include <pleura/nodes/standard/rendering/render_mesh.h>

namespace pleura {

/// A point of a profile that is turned about the y axis, and the outward normal there.
struct ProfilePoint {
  float radius, y;              // [m]
  float normalRadius, normalY;  // a unit vector
};

/// Adds the surface that the profile, run through from top to bottom, sweeps in a whole turn; front faces
/// look outwards.
void addRevolved(std::span<const ProfilePoint> profile, RenderMesh& mesh);

/// Empties the mesh for new faces, its revisions raised.
void startPrimitive(RenderMesh& mesh, bool solid);

}  // namespace pleura
