#pragma once

#include <array>

#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/anatomy/chest_wall.h>

namespace pleura {

/// The thoracic face of a scanned diaphragm, sheet or closed slab, as an open sheet facing lungs and ribs,
/// refined if coarse, pushed off the walls (left, right) and bones; its parts told from its shape: tendon
/// where it slopes under 20 degrees, wall below the edge of the dome, rim at the end of the wall. Throws
/// std::invalid_argument if there is no such face.
Diaphragm scannedDiaphragm(TriangleMesh mesh, const std::array<ChestWall, 2>& walls,
                           const SurfaceQuery& bones);

/// A scanned lung, skinned anew as fillLung does: grown to kPleuralGap from chest wall and diaphragm where it
/// is near them, its faces told from what they touch.
Lung scannedLung(const TriangleMesh& mesh, Side side, const ChestWall& wall, const SurfaceQuery& bones,
                 const SurfaceQuery& diaphragm);

}  // namespace pleura
