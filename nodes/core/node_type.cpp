#include <pleura/nodes/core/node_type.h>

namespace pleura {

NodeType& NodeType::named(std::string name, std::string component, int level) {
  name_ = std::move(name);
  component_ = std::move(component);
  level_ = level;
  return *this;
}

NodeField& NodeType::add(std::string name) {
  NodeField*& declared = byName_[name];
  if (declared == nullptr) {
    fields_.push_back(std::make_unique<NodeField>());
    declared = fields_.back().get();
  }
  *declared = NodeField();
  declared->name = std::move(name);
  return *declared;
}

const NodeField* NodeType::find(std::string_view name) const {
  if (const auto exact = byName_.find(name); exact != byName_.end()) return exact->second;
  constexpr std::string_view kSet = "set_";
  constexpr std::string_view kChanged = "_changed";
  std::string_view stem;
  if (name.starts_with(kSet)) stem = name.substr(kSet.size());
  if (name.ends_with(kChanged)) stem = name.substr(0, name.size() - kChanged.size());
  const auto found = byName_.find(stem);
  return found != byName_.end() && found->second->access == Access::inputOutput ? found->second : nullptr;
}

void NodeType::attachFields(Node& node) const {
  node.type_ = this;
  for (const auto& declared : fields_) {
    Field& field = declared->of(node);
    field.attach(&node, declared.get());
    if (declared->setDefault) declared->setDefault(field);
  }
}

}  // namespace pleura
