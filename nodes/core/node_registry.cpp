#include <pleura/fields/nearest_name.h>
#include <pleura/nodes/core/node_registry.h>

namespace pleura {

void NodeRegistry::add(const NodeType& type) {
  if (!byName_.emplace(type.name(), &type).second)
    throw DuplicateTypeError("node type " + type.name() + " is registered twice");
}

void NodeRegistry::addAlias(const std::string& alias, const std::string& type) {
  if (!byName_.emplace(alias, byName_.at(type)).second)
    throw DuplicateTypeError("node type " + alias + " is registered twice");
}

const NodeType* NodeRegistry::find(std::string_view name) const {
  const auto found = byName_.find(name);
  return found != byName_.end() ? found->second : nullptr;
}

std::string NodeRegistry::nearest(std::string_view name) const {
  std::vector<std::string_view> known;
  for (const auto& [each, type] : byName_) known.push_back(each);
  return nearestName(name, known);
}

std::vector<const NodeType*> NodeRegistry::types() const {
  std::vector<const NodeType*> all;
  for (const auto& [name, type] : byName_)
    if (type->name() == name) all.push_back(type);
  return all;
}

}  // namespace pleura
