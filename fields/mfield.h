#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include <pleura/fields/field.h>
#include <pleura/fields/text.h>

namespace pleura {

/// A field of any number of values. Every change sends one event.
template <class T, FieldType kType>
class MField : public Field {
 public:
  using value_type = std::vector<T>;
  using value_field = MField;  // as SField's
  static constexpr FieldType kFieldType = kType;

  FieldType getType() const override { return kType; }

  /// The values, evaluated first if an event is pending. Throws FieldAccessError for an inputOnly field of a
  /// node.
  const std::vector<T>& getValue(NodeId id = nullptr) {
    checkGet(id);
    upToDate();
    return value;
  }
  /// Throws std::out_of_range.
  typename std::vector<T>::const_reference getValueByIndex(std::size_t index, NodeId id = nullptr) {
    return getValue(id).at(index);
  }
  std::size_t size() { return upToDate(), value.size(); }
  bool empty() { return size() == 0; }

  /// Stores the values and sends an event, even when they are equal; what was pending from routes is dropped.
  /// Throws FieldAccessError for an outputOnly field of a node.
  void setValue(const std::vector<T>& v, NodeId id = nullptr) {
    checkSet(id);
    value = v;
    touch();
  }
  void setValue(std::vector<T>&& v, NodeId id = nullptr) {
    checkSet(id);
    value = std::move(v);
    touch();
  }
  /// Throws std::out_of_range.
  void setValue(std::size_t index, const T& v, NodeId id = nullptr) {
    edit([&](auto& values) { values.at(index) = v; }, id);
  }
  void push_back(const T& v, NodeId id = nullptr) {
    edit([&](auto& values) { values.push_back(v); }, id);
  }
  void resize(std::size_t count, NodeId id = nullptr) {
    edit([&](auto& values) { values.resize(count); }, id);
  }
  void clear(NodeId id = nullptr) {
    edit([](auto& values) { values.clear(); }, id);
  }
  void swap(std::vector<T>& other, NodeId id = nullptr) {
    edit([&](auto& values) { values.swap(other); }, id);
  }
  /// Removes the first that equals `v`, if there is one.
  void erase(const T& v, NodeId id = nullptr) {
    edit(
        [&](auto& values) {
          const auto found = std::find(values.begin(), values.end(), v);
          if (found != values.end()) values.erase(found);
        },
        id);
  }

  /// Lets `change(values)` write the values in place: no copy, no allocation, one event after it.
  template <class Change>
  void edit(Change change, NodeId id = nullptr) {
    checkSet(id);
    upToDate();
    change(value);
    touch();
  }

  std::string getValueAsString() override {
    upToDate();
    std::string text;
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i > 0) text += ' ';
      print(text, static_cast<typename std::vector<T>::const_reference>(value[i]));
    }
    return text;
  }

  void setValueFromString(std::string_view text, NodeId id = nullptr, double scale = 1) override {
    if constexpr (std::is_same_v<T, std::string>)
      if (isUnquoted(text)) return setValue({std::string(text)}, id);
    std::vector<T> read;
    TextReader reader(text, scale);
    while (!reader.atEnd()) {
      const std::size_t at = reader.offset();
      T one{};
      reader.read(one);
      checkRange(one, at);
      read.push_back(std::move(one));
    }
    setValue(std::move(read), id);
  }

 protected:
  /// The last sender wins.
  void update() override {
    auto* sender = static_cast<MField*>(event.sender);
    sender->upToDate();
    value = sender->value;
  }

  std::vector<T> value;
};

}  // namespace pleura
