#include <cstdlib>

#include <pleura/nodes/core/plugin.h>

extern "C" {
int pleura_plugin_abi() { return pleura::kPluginAbi + 1; }
void pleura_register_nodes(pleura::NodeRegistry*) { std::abort(); }
}
