#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/anatomy/cartilages.h>
#include <pleura/nodes/thorax/anatomy/diaphragm.h>
#include <pleura/nodes/thorax/anatomy/lungs.h>
#include <pleura/nodes/thorax/anatomy/ribs.h>
#include <pleura/nodes/thorax/anatomy/sternum.h>
#include <pleura/nodes/thorax/anatomy/vertebrae.h>

namespace pleura {

Anatomy generateAnatomy() {
  Anatomy anatomy;
  anatomy.ribs = generateRibs();
  anatomy.cartilages = generateCartilages(anatomy.ribs);
  anatomy.sternum = generateSternum();
  anatomy.vertebrae = generateVertebrae();
  const std::array<ChestWall, 2> walls{ChestWall(anatomy.ribs, anatomy.cartilages, Side::Left, kPleuralGap),
                                       ChestWall(anatomy.ribs, anatomy.cartilages, Side::Right, kPleuralGap)};
  const DiaphragmShape shape;
  anatomy.diaphragm = generateDiaphragm(shape, walls);
  anatomy.lungs = generateLungs(anatomy, walls, shape);
  return anatomy;
}

}  // namespace pleura
