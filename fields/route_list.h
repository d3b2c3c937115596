#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace pleura {

class Field;

/// Fields at the other ends of a field's routes, in the order the routes were made. One, which is what most
/// fields have, stands in the list itself: no memory is allocated for it, and none is looked up.
class RouteList {
 public:
  using value_type = Field*;
  using const_iterator = Field* const*;

  RouteList() = default;
  RouteList(const RouteList&) = delete;
  RouteList& operator=(const RouteList&) = delete;
  ~RouteList() {
    if (capacity_ > 1) delete[] many_;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const_iterator begin() const { return capacity_ > 1 ? many_ : &one_; }
  const_iterator end() const { return begin() + size_; }
  Field* operator[](std::size_t index) const { return begin()[index]; }
  Field* back() const { return end()[-1]; }
  bool contains(const Field* field) const { return std::find(begin(), end(), field) != end(); }

  void push_back(Field* field) {
    if (size_ == capacity_) grow();
    fields()[size_++] = field;
  }
  void pop_back() { --size_; }
  /// Searches from the back, where the destructor of a field takes them.
  void remove(const Field* field) {
    const auto found = std::find(std::reverse_iterator(end()), std::reverse_iterator(begin()), field).base();
    if (found == begin()) return;
    std::copy(found, end(), fields() + (found - begin()) - 1);
    --size_;
  }

 private:
  Field** fields() { return capacity_ > 1 ? many_ : &one_; }
  void grow() {
    auto* more = new Field*[2 * std::size_t{capacity_}];
    std::copy(begin(), end(), more);
    if (capacity_ > 1) delete[] many_;
    many_ = more;
    capacity_ *= 2;
  }

  union {
    Field* one_ = nullptr;
    Field** many_;
  };
  std::uint32_t size_ = 0;
  std::uint32_t capacity_ = 1;
};

}  // namespace pleura
