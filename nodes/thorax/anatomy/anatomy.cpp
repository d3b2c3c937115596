#include <fmt/format.h>
#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/anatomy/ribs.h>

#include <stdexcept>

namespace pleura {
namespace {

template <class Part>
const Part& find(const std::vector<Part>& parts, Side side, int number, const char* kind) {
  for (const Part& part : parts) {
    if (part.side == side && part.number == number) return part;
  }
  throw std::out_of_range(fmt::format("{}: no number {}", kind, number));
}

}  // namespace

const Rib& rib(const Anatomy& anatomy, Side side, int number) {
  return find(anatomy.ribs, side, number, "rib");
}

const Cartilage& cartilage(const Anatomy& anatomy, Side side, int number) {
  return find(anatomy.cartilages, side, number, "cartilage");
}

Anatomy generateAnatomy() {
  Anatomy anatomy;
  anatomy.ribs = generateRibs();
  return anatomy;
}

}  // namespace pleura
