#include <pleura/nodes/thorax/motion/thorax_motion.h>

namespace pleura {

ThoraxMotion::ThoraxMotion(const Anatomy& anatomy, const DomeMotion& dome,
                           const std::array<RibAngles, 12>& left, const std::array<RibAngles, 12>& right)
    : cage_(anatomy, left, right),
      sides_{buildHemithorax(anatomy, cage_, Side::Left, dome.foldDrop),
             buildHemithorax(anatomy, cage_, Side::Right, dome.foldDrop)},
      diaphragm_(anatomy.diaphragm, sides_, dome),
      lungs_{LungMotion(anatomy.lungs[0], sides_[0], anatomy.diaphragm.mesh),
             LungMotion(anatomy.lungs[1], sides_[1], anatomy.diaphragm.mesh)},
      walls_{sides_[0].wall.rest, sides_[1].wall.rest},
      diaphragmPoints_(anatomy.diaphragm.mesh.points),
      lungPoints_{anatomy.lungs[0].mesh.points, anatomy.lungs[1].mesh.points} {
  evaluate(0.0);
}

void ThoraxMotion::evaluate(double inflation) {
  bodies_ = cage_.bodies(inflation);
  const BodyDisplacements displacements = displacementsOf(bodies_);
  for (std::size_t side = 0; side < 2; ++side) moveWall(sides_[side].wall, displacements, walls_[side]);
  diaphragm_.move(sides_, {walls_[0], walls_[1]}, inflation, diaphragmPoints_);
  for (std::size_t side = 0; side < 2; ++side) {
    lungs_[side].move(sides_[side], walls_[side], diaphragmPoints_, inflation, lungPoints_[side]);
  }
}

}  // namespace pleura
