#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <pleura/nodes/core/node_type.h>

namespace pleura {

/// A type or an alias was registered twice.
struct DuplicateTypeError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The node types that a scene may name. One line of registration each.
class NodeRegistry {
 public:
  /// Throws DuplicateTypeError.
  template <class T>
  void add() {
    add(nodeType<T>());
  }
  void add(const NodeType& type);
  /// Another name for a known type. Throws DuplicateTypeError, std::out_of_range.
  void addAlias(const std::string& alias, const std::string& type);

  /// Null when there is none.
  const NodeType* find(std::string_view name) const;
  /// The known name nearest to a misspelt one; empty when none is near.
  std::string nearest(std::string_view name) const;
  /// In alphabetical order, aliases left out.
  std::vector<const NodeType*> types() const;

 private:
  std::map<std::string, const NodeType*, std::less<>> byName_;
};

}  // namespace pleura
