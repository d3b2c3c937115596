#include <array>

#include <pleura/nodes/lung/causality/sign_constraints.h>

namespace pleura {
namespace {

constexpr std::array kSigns = {Sign::falls, Sign::stands, Sign::rises};

bool isSum(Sign a, Sign b, Sign c) {
  if (a == opposite(b)) return a != Sign::stands || c == Sign::stands;
  return c == (a == Sign::stands ? b : a);
}

SignSet none() { return SignSet(Sign::falls) & SignSet(Sign::rises); }

// Keeps of each set the signs that some allowed choice has.
template <class Allows>
bool narrow(SignSet& a, SignSet& b, SignSet& c, Allows allows) {
  SignSet stillA = none(), stillB = none(), stillC = none();
  for (const Sign x : kSigns)
    for (const Sign y : kSigns)
      for (const Sign z : kSigns) {
        if (!a.contains(x) || !b.contains(y) || !c.contains(z) || !allows(x, y, z)) continue;
        stillA = stillA | x;
        stillB = stillB | y;
        stillC = stillC | z;
      }
  const bool hasChanged = stillA != a || stillB != b || stillC != c;
  a = stillA, b = stillB, c = stillC;
  return hasChanged;
}

template <class Allows>
bool narrowPair(SignSet& a, SignSet& b, Allows allows) {
  const SignSet beforeA = a, beforeB = b;
  SignSet any;
  narrow(a, b, any, [&](Sign x, Sign y, Sign) { return allows(x, y); });
  return a != beforeA || b != beforeB;
}

}  // namespace

bool narrowAlike(SignSet& a, SignSet& b) {
  return narrowPair(a, b, [](Sign x, Sign y) { return x == y; });
}

bool narrowContrary(SignSet& a, SignSet& b) {
  return narrowPair(a, b, [](Sign x, Sign y) { return x == opposite(y); });
}

bool narrowSum(SignSet& a, SignSet& b, SignSet& c) { return narrow(a, b, c, isSum); }

bool narrowProduct(SignSet& a, SignSet& b, SignSet& c) {
  return narrow(a, b, c, [](Sign x, Sign y, Sign z) {
    return isSum(x, y, z) || (y == Sign::stands && z == Sign::stands);
  });
}

}  // namespace pleura
