#pragma once

#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/anatomy/chest_wall.h>

namespace pleura {

/// A scanned diaphragm, sheet or thick slab, with its parts told from its shape: tendon where it slopes under
/// 20 degrees, wall below the edge of the dome, rim at the end of the wall.
Diaphragm scannedDiaphragm(TriangleMesh mesh);

/// A scanned lung, pushed off chest wall, bones and diaphragm to kPleuralGap, its faces told from what they
/// touch.
Lung scannedLung(TriangleMesh mesh, Side side, const ChestWall& wall, const SurfaceQuery& bones,
                 const SurfaceQuery& diaphragm);

}  // namespace pleura
