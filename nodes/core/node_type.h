#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include <pleura/fields/field_declaration.h>
#include <pleura/nodes/core/node.h>

namespace pleura {

/// The class and the field class of a pointer to a member.
template <auto Member>
struct MemberOf;
template <class Class, class FieldClass, FieldClass Class::*kMember>
struct MemberOf<kMember> {
  using node = Class;
  using field = FieldClass;
  using value_type = typename FieldClass::value_type;
};

/// A field as a node type declares it.
struct NodeField : FieldDeclaration {
  Field& (*of)(Node&) = nullptr;           // that field of a node of this type
  std::function<void(Field&)> setDefault;  // null where the default is the empty value
  std::string defaultText;
  bool isExtension = false;  // ours, of a node that X3D has without it

  NodeField& extension() { return isExtension = true, *this; }
  NodeField& measuredIn(Unit u) { return unit = u, *this; }
  NodeField& within(double least, double most) { return minimum = least, maximum = most, *this; }
  NodeField& atLeast(double least) { return minimum = least, *this; }
  NodeField& positive() { return atLeast(std::numeric_limits<float>::min()); }
  NodeField& positive(double most) { return maximum = most, positive(); }
  NodeField& means(std::string text) { return meaning = std::move(text), *this; }
};

/// Lets names be looked up without making a string.
struct NameHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>()(name); }
};

/// What a kind of node is called, where it may stand and which fields it has, filled in by
/// T::declare(NodeType&). Immutable after that and never destroyed before its nodes.
class NodeType {
 public:
  NodeType() = default;
  NodeType(const NodeType&) = delete;
  NodeType& operator=(const NodeType&) = delete;

  /// `component` and `level` as X3D 4.0 has them; "Pleura" for nodes that are ours.
  NodeType& named(std::string name, std::string component, int level = 1);
  /// The field of the parent that takes such a node when the file does not say.
  NodeType& containedIn(std::string field) { return containerField_ = std::move(field), *this; }
  NodeType& means(std::string text) { return meaning_ = std::move(text), *this; }

  /// Declares the member as a field. A class and its bases each declare their own; the last declaration of a
  /// name counts, so that a class may give another default.
  template <auto Member>
  NodeField& field(std::string name, Access access, const typename MemberOf<Member>::value_type& byDefault);

  const std::string& name() const { return name_; }
  const std::string& component() const { return component_; }
  int level() const { return level_; }
  const std::string& containerField() const { return containerField_; }
  const std::string& meaning() const { return meaning_; }
  const std::vector<std::unique_ptr<NodeField>>& fields() const { return fields_; }
  /// By name, `set_name` or `name_changed`; null when there is none.
  const NodeField* find(std::string_view name) const;

  /// A node with all fields attached and at their defaults.
  NodePtr create() const { return make_(); }

 private:
  template <class T>
  friend struct NodeTypeOf;

  NodeField& add(std::string name);
  void attachFields(Node& node) const;

  std::string name_;
  std::string component_ = "Pleura";
  int level_ = 1;
  std::string containerField_ = "children";
  std::string meaning_;
  std::vector<std::unique_ptr<NodeField>> fields_;
  std::unordered_map<std::string, NodeField*, NameHash, std::equal_to<>> byName_;
  NodePtr (*make_)() = nullptr;
};

/// What does not depend on the member but only on its field's type: compiled once for all such members.
template <class ValueField>
void declareValue(NodeField& declared, const typename ValueField::value_type& byDefault) {
  declared.type = ValueField::kFieldType;
  declared.setDefault = [byDefault](Field& field) {
    static_cast<ValueField&>(field).setValue(byDefault, field.getOwner());
  };
  ValueField sample;
  const std::string empty = sample.getValueAsString();
  declared.setDefault(sample);
  declared.defaultText = sample.getValueAsString();
  if (declared.defaultText == empty) declared.setDefault = nullptr;
}

template <auto Member>
NodeField& NodeType::field(std::string name, Access access,
                           const typename MemberOf<Member>::value_type& byDefault) {
  NodeField& declared = add(std::move(name));
  declareValue<typename MemberOf<Member>::field::value_field>(declared, byDefault);
  declared.access = access;
  declared.of = [](Node& node) -> Field& {
    using Class = typename MemberOf<Member>::node;
    if constexpr (std::is_base_of_v<Node, Class>) {
      return static_cast<Class&>(node).*Member;
    } else {
      return dynamic_cast<Class&>(node).*Member;  // of a base beside Node, as X3DBoundedObject
    }
  };
  return declared;
}

template <class T>
struct NodeTypeOf {
  NodeType type;
  NodeTypeOf() {
    T::declare(type);
    type.make_ = []() -> NodePtr { return make(); };
  }
  static const NodeTypeOf& get() {
    static const NodeTypeOf declared;
    return declared;
  }
  static std::shared_ptr<T> make() {
    auto node = std::make_shared<T>();
    get().type.attachFields(*node);
    return node;
  }
};

/// The type of T, declared at the first call.
template <class T>
const NodeType& nodeType() {
  return NodeTypeOf<T>::get().type;
}

/// A node of class T with its fields at their defaults.
template <class T>
std::shared_ptr<T> create() {
  return NodeTypeOf<T>::make();
}

}  // namespace pleura
