#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <pleura/nodes/core/node.h>
#include <pleura/x3d/encoding/diagnostics.h>

namespace pleura {

/// A ROUTE as the file has it.
struct RouteStatement {
  std::string fromNode, fromField, toNode, toField;
};

/// An IMPORT as the file has it: `node` of the file that the Inline loads is known here as `as`.
struct ImportStatement {
  std::string inlineName, node, as;
};

/// A `<unit>`: numbers of this category in the file are multiplied by `factor` to be SI.
struct UnitStatement {
  std::string category, name;
  double factor = 1;
};

/// What an X3D file says: its head, its nodes and the statements about them.
struct Document {
  std::string version = "4.0";
  std::string profile = "Immersive";
  std::vector<std::pair<std::string, int>> components;    // name, level
  std::vector<std::pair<std::string, std::string>> meta;  // name, content
  std::vector<UnitStatement> units;
  std::vector<std::string> libraries;                        // ImportLibrary, as written
  std::vector<NodePtr> nodes;                                // the roots
  std::map<std::string, NodePtr, std::less<>> names;         // DEF, and what IMPORT added
  std::vector<std::pair<std::string, std::string>> exports;  // DEF name, exported name
  std::vector<ImportStatement> imports;
  std::vector<RouteStatement> routes;
};

}  // namespace pleura
