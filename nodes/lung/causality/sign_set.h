#pragma once

#include <bit>
#include <cstdint>

namespace pleura {

/// What a quantity does at a moment.
enum class Sign : std::int8_t { falls = -1, stands = 0, rises = 1 };

constexpr Sign opposite(Sign sign) { return static_cast<Sign>(-static_cast<int>(sign)); }

/// The sign of a number; stands where it is no larger than `band` >= 0.
constexpr Sign signOf(double x, double band = 0) {
  return x > band ? Sign::rises : x < -band ? Sign::falls : Sign::stands;
}

/// The signs that a quantity may have as far as is known.
class SignSet {
 public:
  constexpr SignSet() = default;  // any
  constexpr SignSet(Sign sign) : SignSet(bitOf(sign)) {}

  /// A number that is known no better than a dead band: sure to stand within half of it, sure not to beyond
  /// twice.
  static constexpr SignSet of(double x, double band) {
    return SignSet(bitOf(signOf(x, 2 * band)) | bitOf(signOf(x, band / 2)));
  }

  constexpr bool contains(Sign sign) const { return (bits_ & bitOf(sign)) != 0; }
  constexpr bool isEmpty() const { return bits_ == 0; }
  constexpr bool isOne() const { return std::popcount(bits_) == 1; }
  constexpr SignSet operator&(SignSet other) const { return SignSet(bits_ & other.bits_); }
  constexpr SignSet operator|(SignSet other) const { return SignSet(bits_ | other.bits_); }
  bool operator==(const SignSet&) const = default;

 private:
  constexpr explicit SignSet(unsigned bits) : bits_(static_cast<std::uint8_t>(bits)) {}
  static constexpr unsigned bitOf(Sign sign) { return 1u << (static_cast<int>(sign) + 1); }

  std::uint8_t bits_ = 7;
};

}  // namespace pleura
