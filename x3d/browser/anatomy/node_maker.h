#pragma once

#include <cassert>
#include <string>
#include <utility>

#include <pleura/nodes/core/node_registry.h>

namespace pleura {

/// Makes nodes by the names of their types and fields. A name that is not there is a programmer's mistake.
class NodeMaker {
 public:
  explicit NodeMaker(const NodeRegistry& registry) : registry_(registry) {}

  NodePtr make(std::string_view type, std::string def = {}) const {
    const NodeType* known = registry_.find(type);
    assert(known != nullptr);
    NodePtr node = known->create();
    node->setName(std::move(def));
    return node;
  }

  template <class FieldClass>
  static void set(const NodePtr& node, std::string_view field, const typename FieldClass::value_type& value) {
    auto* found = dynamic_cast<FieldClass*>(node->getField(field));
    assert(found != nullptr);
    found->setValue(value, node->id);
  }

  static void put(const NodePtr& parent, std::string_view field, const NodePtr& child) {
    Field* found = parent->getField(field);
    if (auto* many = dynamic_cast<MFNode*>(found)) return many->push_back(child, parent->id);
    auto* one = dynamic_cast<SFNode*>(found);
    assert(one != nullptr);
    one->setValue(child, parent->id);
  }

 private:
  const NodeRegistry& registry_;
};

}  // namespace pleura
