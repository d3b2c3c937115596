#pragma once

namespace pleura {

/// Raised whenever the layout or the meaning of a class that plugins see changes; a plugin built for another number
/// is refused.
inline constexpr int kPluginAbi = 1;

/// The number this library was built with.
int pluginAbi();

}  // namespace pleura
