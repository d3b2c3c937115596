#pragma once

#include <span>

#include <pleura/fields/values.h>
#include <pleura/nodes/standard/rendering/face_list.h>

namespace pleura {

/// The area vector of a face: its normal, as long as its area is large [m^2] (Newell's method).
Vec3d areaVector(const FaceList& faces, std::size_t face, std::span<const Vec3f> points);

/// Cuts faces into triangles: three corners each, turning as the face does. Faces of fewer than three corners
/// give none. Convex faces are cut as fans, others by clipping ears in the plane of their area vector; what
/// crosses itself, or has more than 4096 corners, is cut somehow.
std::vector<std::uint32_t> triangulate(const FaceList& faces, std::span<const Vec3f> points, bool areConvex);

}  // namespace pleura
