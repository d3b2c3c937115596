#pragma once

#include <string>
#include <vector>

#include <pleura/nodes/lung/causality/causal_chain.h>

namespace pleura {

/// A sentence of what the quantity does and because of what, for a lesson: "The intrapleural pressure falls
/// because the chest cavity grows."
std::string sentence(const CausalChain& chain, Quantity quantity);

/// What a lesson tells of a moment: the turn of the breath or a pause where it is one, why the lung does not
/// follow the chest wall where gas keeps it from that, then a sentence for each quantity, cause before
/// effect.
std::vector<std::string> tell(const CausalChain& chain);

}  // namespace pleura
