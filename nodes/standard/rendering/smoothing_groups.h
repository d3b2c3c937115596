#pragma once

#include <span>

#include <pleura/fields/values.h>
#include <pleura/nodes/standard/rendering/face_list.h>

namespace pleura {

/// Which corners share a normal: the number of its group for each corner. Corners at one point share it when
/// one gets from face to face across edges at which the faces' normals differ by less than `creaseAngle`
/// [rad] (X3D 11.2.3). From pi on all corners at a point share, with 0 none do but those of one face.
std::vector<std::uint32_t> smoothingGroups(const FaceList& faces, std::span<const Vec3f> points,
                                           double creaseAngle);

}  // namespace pleura
