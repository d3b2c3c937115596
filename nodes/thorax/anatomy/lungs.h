#pragma once

#include <functional>
#include <vector>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/anatomy/diaphragm.h>
#include <pleura/nodes/thorax/anatomy/implicit_surface.h>

namespace pleura {

/// Gap left between a lung at rest and bone or diaphragm: the two pleurae and what is between them.
inline constexpr double kPleuralGap = 0.0015;  // [m]

/// The shape that a lung fills up to wall and diaphragm: about the distance to its skin, negative inside [m],
/// a box around it, and the width [m] of detail in it that is none.
struct LungOutline {
  Side side = Side::Left;
  Solid distance;
  Eigen::AlignedBox3d box;
  double blur = 0.0;
};

/// Height [m] of the diaphragm's dome above or below a point.
using DomeHeight = std::function<double(const Eigen::Vector3d&)>;

/// A lung of that outline, grown out to the chest wall and down to the diaphragm where they are near.
Lung fillLung(const LungOutline& outline, const ChestWall& wall, const DomeHeight& height,
              const SurfaceQuery& bones, const SurfaceQuery& diaphragm);

/// Left and right lung: the measured outlines towards heart and spine (measurements/lungs.csv), elsewhere
/// grown out to the chest wall and down to the diaphragm. `rest` has everything but the lungs.
std::vector<Lung> generateLungs(const Anatomy& rest, const std::array<ChestWall, 2>& walls,
                                const DiaphragmShape& shape);

}  // namespace pleura
