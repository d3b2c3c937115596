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
  const DiaphragmShape diaphragm;
  anatomy.diaphragm = generateDiaphragm(diaphragm);
  anatomy.lungs = generateLungs(anatomy, diaphragm);
  return anatomy;
}

}  // namespace pleura
