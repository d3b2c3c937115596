#pragma once

#include <vector>

#include <pleura/fields/values.h>

namespace pleura {

/// What a lattice can't resolve is nearly the same for each model: shapes X(h) of cell size h, corrected by
/// those Y of a cheaper model, in which a finer lattice can be afforded (defect correction, Stetter 1978),
///   X(h') ~ X(h) + Y(h') - Y(h).
/// Driven points stay where all three have them, bit for bit.
std::vector<std::vector<Vec3f>> correctedShapes(std::vector<std::vector<Vec3f>> shapes,
                                                const std::vector<std::vector<Vec3f>>& cheapFine,
                                                const std::vector<std::vector<Vec3f>>& cheap);

}  // namespace pleura
