#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pleura {

/// The nearest of `known` to `name` by edit distance, letters' case ignored, if at most a third of the
/// letters differ; else empty.
std::string nearestName(std::string_view name, std::span<const std::string_view> known);
/// What a message of an unknown name ends with: "; did you mean NEAREST?", or nothing where none is near.
std::string didYouMean(const std::string& nearest);
/// Whether both are the same but for the case of their letters.
bool isSameName(std::string_view a, std::string_view b);

}  // namespace pleura
