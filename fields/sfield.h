#pragma once

#include <type_traits>
#include <utility>

#include <pleura/fields/field.h>
#include <pleura/fields/text.h>

namespace pleura {

/// A field of one value. `kType` keeps apart what has the same C++ type: SFTime from SFDouble, SFColor from
/// SFVec3f.
template <class T, FieldType kType>
class SField : public Field {
 public:
  using value_type = T;
  using value_field = SField;  // what a class derived from this one is, but for how it gets its value
  static constexpr FieldType kFieldType = kType;

  SField() {
    if constexpr (std::is_arithmetic_v<T>) {
      value = T{};
    } else if constexpr (requires { T::Zero(); }) {
      value = T::Zero();
    }
  }

  FieldType getType() const override { return kType; }

  /// The value, evaluated first if an event is pending. Throws FieldAccessError for an inputOnly field of a
  /// node.
  const T& getValue(NodeId id = nullptr) {
    checkGet(id);
    upToDate();
    return value;
  }

  /// Stores the value and sends an event, even when it is equal; what was pending from routes is dropped.
  /// Throws FieldAccessError for an outputOnly field of a node.
  void setValue(const T& v, NodeId id = nullptr) {
    checkSet(id);
    value = v;
    touch();
  }
  void setValue(T&& v, NodeId id = nullptr) requires(!std::is_trivially_copyable_v<T>) {
    checkSet(id);
    value = std::move(v);
    touch();
  }

  /// As setValue, but silent when the value is the one it has.
  void setValueIfChanged(const T& v, NodeId id = nullptr) {
    checkSet(id);
    upToDate();
    if (!(value == v)) setValue(v, id);
  }

  std::string getValueAsString() override {
    upToDate();
    std::string text;
    if constexpr (std::is_same_v<T, std::string>) {
      text = value;
    } else {
      print(text, value);
    }
    return text;
  }

  void setValueFromString(std::string_view text, NodeId id = nullptr, double scale = 1) override {
    if constexpr (std::is_same_v<T, std::string>) {
      setValue(std::string(text), id);
      static_cast<void>(scale);
    } else {
      T read{};
      TextReader reader(text, scale);
      reader.read(read);
      reader.expectEnd();
      checkRange(read, 0);
      setValue(std::move(read), id);
    }
  }

 protected:
  /// The last sender wins.
  void update() override {
    auto* sender = static_cast<SField*>(event.sender);
    sender->upToDate();
    value = sender->value;
  }

  T value;
};

}  // namespace pleura
