#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <pleura/fields/field_types.h>

namespace pleura {

class NodeType;
class SceneContext;

/// Where a node stands in the file that it was read from, counted from 1. Without a file: it was not read.
struct NodePlace {
  std::shared_ptr<const std::string> file = {};
  int line = 0;
  int column = 0;
};

/// A member of the scene graph: a set of fields and what they mean together (X3DNode). Its fields are members
/// of the class, declared once in its `static void declare(NodeType&)`; nodes are made by create<T>() or by a
/// NodeRegistry.
class Node : public FieldOwner {
 public:
  Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  virtual ~Node() = default;

  /// Passed to its own fields, it exempts the node from their access rules.
  const NodeId id = this;

  SFNode metadata;

  const NodeType& type() const { return *type_; }
  const std::string& getName() const { return name_; }
  void setName(std::string def) { name_ = std::move(def); }
  std::string describe() const override;
  const NodePlace& place() const { return place_; }
  void setPlace(NodePlace place) { place_ = std::move(place); }

  /// The field of that name, `set_name` and `name_changed` understood; null when there is none.
  Field* getField(std::string_view name);

  bool isInitialized() const { return context_ != nullptr; }
  /// Called once, when the fields have their first values: initializeOnly fields are closed, then
  /// onInitialize(). The context outlives the node.
  void initialize(SceneContext& context);

  static void declare(NodeType& type);

 protected:
  /// Routes that the node makes among its own fields and from the scene's.
  virtual void onInitialize() {}
  /// Only after initialize().
  SceneContext& context() const { return *context_; }

 private:
  friend class NodeType;
  const NodeType* type_ = nullptr;
  SceneContext* context_ = nullptr;
  std::string name_;
  NodePlace place_;
};

}  // namespace pleura
