#pragma once

#include <string>
#include <string_view>

namespace pleura {

/// The text as it stands in XML, in an attribute between two of `quote`, or between tags. XML keeps line ends
/// and tabs of attributes only as references.
std::string xmlText(std::string_view text, char quote = '\'');

}  // namespace pleura
