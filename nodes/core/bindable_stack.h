#pragma once

#include <algorithm>
#include <vector>

namespace pleura {

/// A node that shares its role with others of its kind: one of them plays it.
class Bindable {
 public:
  /// The node takes the role, or loses it.
  virtual void onBound(bool isBound) = 0;

 protected:
  ~Bindable() = default;
};

/// The bound nodes of one kind; the one on top is in use (X3D 7.2.2).
class BindableStack {
 public:
  Bindable* top() const { return bound_.empty() ? nullptr : bound_.back(); }

  /// Puts `node` on top: the node that was there loses the role, `node` takes it.
  void bind(Bindable* node) {
    if (node == top()) return;
    Bindable* before = top();
    std::erase(bound_, node);
    bound_.push_back(node);
    if (before != nullptr) before->onBound(false);
    node->onBound(true);
  }

  /// Takes `node` off: if it was on top, it loses the role and the one below takes it.
  void unbind(Bindable* node) {
    const bool wasTop = node == top();
    std::erase(bound_, node);
    if (!wasTop || node == nullptr) return;
    node->onBound(false);
    if (top() != nullptr) top()->onBound(true);
  }

 private:
  std::vector<Bindable*> bound_;
};

}  // namespace pleura
