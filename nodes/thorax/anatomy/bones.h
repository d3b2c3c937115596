#pragma once

#include <vector>

#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// Several meshes as one, points and triangles in their order.
TriangleMesh merged(const std::vector<const TriangleMesh*>& meshes);

/// All bones, discs and cartilages as one surface to ask for distances.
SurfaceQuery bonesOf(const Anatomy& anatomy);

}  // namespace pleura
