#pragma once

#include <array>
#include <cmath>

#include <Eigen/Core>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace pleura::haptics {

/// A float for each of four things side by side.
using FourNumbers = Eigen::Array<float, 4, 1>;
/// Four places [m]; column k holds coordinate k.
using FourPlaces = Eigen::Array<float, 4, 3>;

/// Bit k is set where number k has a minus sign.
inline unsigned minusSigns(const FourNumbers& numbers) {
#if defined(__SSE__)
  return static_cast<unsigned>(_mm_movemask_ps(_mm_loadu_ps(numbers.data())));
#else
  unsigned signs = 0;
  for (unsigned k = 0; k < 4; ++k) signs |= static_cast<unsigned>(std::signbit(numbers[k])) << k;
  return signs;
#endif
}

/// The places 0..3 of the bits that are set in each of the numbers 0..15, packed to the front.
struct SetBits {
  alignas(16) std::array<int, 4> places{};
  int count = 0;
};
inline constexpr std::array<SetBits, 16> kSetBits = [] {
  std::array<SetBits, 16> all;
  for (unsigned bits = 0; bits < 16; ++bits)
    for (int k = 0; k < 4; ++k)
      if ((bits >> k & 1U) != 0) all[bits].places[all[bits].count++] = k;
  return all;
}();

/// Writes first + k to out[0], out[1], ... for each k whose number has a minus sign; what is behind them up
/// to out[3] is of no use. Returns how many there are. Without a branch: it would be guessed wrong.
inline int putNegative(const FourNumbers& numbers, int first, int* out) {
  const SetBits& set = kSetBits[minusSigns(numbers)];
  using FourInts = Eigen::Array<int, 4, 1>;
  Eigen::Map<FourInts>{out} = Eigen::Map<const FourInts, Eigen::Aligned16>(set.places.data()) + first;
  return set.count;
}

/// Four boxes along the axes [m].
struct FourBoxes {
  FourPlaces low = FourPlaces::Zero();
  FourPlaces high = FourPlaces::Zero();

  /// [m^2] from a point to each box, 0 inside.
  FourNumbers squaredDistance(const Eigen::Vector3f& p) const {
    FourNumbers squared = FourNumbers::Zero();
    for (int k = 0; k < 3; ++k) squared += (low.col(k) - p[k]).max(p[k] - high.col(k)).max(0.0F).square();
    return squared;
  }

  /// Box k becomes the one about four others.
  void enclose(int k, const FourBoxes& others) {
    low.row(k) = others.low.colwise().minCoeff();
    high.row(k) = others.high.colwise().maxCoeff();
  }
};

}  // namespace pleura::haptics
