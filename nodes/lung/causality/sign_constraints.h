#pragma once

#include <pleura/nodes/lung/causality/sign_set.h>

// What is known of some quantities narrows what others may do: the constraints of QSIM (Kuipers, Artificial
// Intelligence 29, 1986) over directions of change. Each removes the signs that no choice of the other
// quantities goes with, and returns whether it removed any. A set that runs empty: what was known contradicts
// itself.

namespace pleura {

/// b rises with a and falls with it (QSIM's M+).
bool narrowAlike(SignSet& a, SignSet& b);

/// b falls as a rises (QSIM's M-).
bool narrowContrary(SignSet& a, SignSet& b);

/// a + b = c.
bool narrowSum(SignSet& a, SignSet& b, SignSet& c);

/// a b = c, all positive, where a's relative change can be too small to be seen in c's: with b and c
/// standing, a may do anything.
bool narrowProduct(SignSet& a, SignSet& b, SignSet& c);

}  // namespace pleura
