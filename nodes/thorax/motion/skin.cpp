#include <pleura/nodes/thorax/motion/skin.h>

#include <stdexcept>

namespace pleura {

void BodyWeights::add(int index, double w) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    if (body[k] == index) {
      weight[k] += w;
      return;
    }
  }
  if (count == kMax) throw std::invalid_argument("BodyWeights: at most five bodies carry a point");
  body[static_cast<std::size_t>(count)] = index;
  weight[static_cast<std::size_t>(count++)] = w;
}

BodyWeights rigidWith(int body) {
  BodyWeights weights;
  weights.add(body, 1.0);
  return weights;
}

BodyWeights mix(const BodyWeights& a, const BodyWeights& b, double t) {
  BodyWeights mixed;
  for (std::size_t k = 0; k < static_cast<std::size_t>(a.count); ++k) mixed.add(a.body[k], (1.0 - t) * a.weight[k]);
  for (std::size_t k = 0; k < static_cast<std::size_t>(b.count); ++k) mixed.add(b.body[k], t * b.weight[k]);
  return mixed;
}

}  // namespace pleura
