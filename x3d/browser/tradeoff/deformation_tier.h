#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pleura {

/// A way to deform an organ: a deformer node and its fields.
struct DeformationTier {
  std::string method;  // "ChainMail", "linear FEM", ...
  std::string node;    // type; empty: the smooth fill of the contacts themselves
  std::vector<std::pair<std::string, std::string>> fields;
  int elements = 0;  // of a lattice; 0: none

  std::string name() const { return elements > 0 ? method + " " + std::to_string(elements) : method; }
};

/// The cheap ones first; lattices of `coarse` cells and of eight times as many, whose cubes may be cut in
/// five.
std::vector<DeformationTier> deformationTiers(int coarse);

/// The tier of that method and number of elements; without a node for a method that there is not.
DeformationTier tierOf(const std::string& method, int elements);

inline constexpr auto kReferenceMethod = "reference";
/// The method whose finest lattice is the reference.
inline constexpr auto kReferenceModel = "Neo-Hookean FEM";

/// What all are measured against: stable Neo-Hookean, two levels finer than the coarsest lattice, corrected
/// by what linear elements still move from there to `finer` (see corrected_shapes.h).
struct ReferenceTiers {
  DeformationTier nonlinear, linear, finer;
};
ReferenceTiers referenceTiers(int coarse);

}  // namespace pleura
