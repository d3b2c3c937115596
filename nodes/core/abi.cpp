#include <pleura/nodes/core/abi.h>

namespace pleura {

int pluginAbi() { return kPluginAbi; }

}  // namespace pleura
