#pragma once

#include <string>

#include <pleura/x3d/encoding/document.h>

namespace pleura {

/// The document as X3D's XML encoding: only what differs from the defaults, nodes that stand twice as DEF and
/// USE, all numbers so that they read back the same. Nodes must outlive the call; names are given to nameless
/// nodes that need one.
std::string writeX3d(Document& document);

}  // namespace pleura
