#pragma once

#include <string>
#include <vector>

#include <pleura/nodes/core/node_type.h>

namespace pleura {

/// A line a type: name, component, meaning.
std::string referenceAsList(const std::vector<const NodeType*>& types);
/// One type with all its fields: type, access, default, unit, range, meaning.
std::string referenceAsText(const NodeType& type);
/// A section with a table for each type.
std::string referenceAsMarkdown(const std::vector<const NodeType*>& types);
/// An XML schema of the types' elements and attributes.
std::string referenceAsXsd(const std::vector<const NodeType*>& types);

}  // namespace pleura
