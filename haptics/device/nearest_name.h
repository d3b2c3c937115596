#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pleura::haptics {

/// "; did you mean NAME?" of the known name that is fewest letters away, case ignored; empty when none is
/// near.
std::string didYouMean(std::string_view name, std::span<const std::string_view> known);

/// Whether both are the same but for the case of their letters.
bool isSameName(std::string_view a, std::string_view b);

}  // namespace pleura::haptics
