#pragma once

#include <string>

#include <pleura/fields/errors.h>
#include <pleura/fields/field_types.h>

namespace pleura {

/// One input that may be of any of these field classes.
template <class... Fields>
struct Any {};

/// The inputs of a TypedField, one class (or one Any) each, in the order of the routes.
template <class... Inputs>
struct Types {};

/// Any number of inputs, none included, each of this class (or Any).
template <class Input>
struct AnyNumber {};

namespace typed_field {

template <class Input>
struct Match {
  static bool matches(const Field& field) { return dynamic_cast<const Input*>(&field) != nullptr; }
  static std::string expected() { return std::string(name(Input::kFieldType)); }
};

template <class First, class... Rest>
struct Match<Any<First, Rest...>> {
  static bool matches(const Field& field) {
    return Match<First>::matches(field) || (Match<Rest>::matches(field) || ...);
  }
  static std::string expected() {
    return (Match<First>::expected() + ... + (" or " + Match<Rest>::expected()));
  }
};

/// Input number `index` of a list: does the field fit, and what would?
template <class List>
struct Inputs;

template <class... List>
struct Inputs<Types<List...>> {
  static constexpr std::size_t kCount = sizeof...(List);
  static constexpr bool kOpenEnded = false;
  static bool matches(std::size_t index, const Field& field) {
    std::size_t i = 0;
    return ((i++ == index && Match<List>::matches(field)) || ...);
  }
  static std::string expected(std::size_t index) {
    std::string text;
    std::size_t i = 0;
    ((i++ == index ? void(text = Match<List>::expected()) : void()), ...);
    return text;
  }
};

template <class Input>
struct Inputs<AnyNumber<Input>> {
  static constexpr std::size_t kCount = 0;
  static constexpr bool kOpenEnded = true;
  static bool matches(std::size_t, const Field& field) { return Match<Input>::matches(field); }
  static std::string expected(std::size_t) { return Match<Input>::expected(); }
};

/// A bare Any stands for any number of inputs, as H3D has it.
template <class... Fields>
struct Inputs<Any<Fields...>> : Inputs<AnyNumber<Any<Fields...>>> {};

}  // namespace typed_field

/// A field whose value is computed from inputs of given classes, checked when a route is made and when it is
/// evaluated after routes have changed. Override update(): read `routes_in[i]`, write `value`.
///
///   class Sum : public TypedField<SFFloat, Types<SFFloat, SFFloat>> { void update() override { ... } };
///
/// `Required` inputs come first, each once; `Optional` ones may follow.
template <class Base, class Required, class Optional = Types<>>
class TypedField : public Base {
 protected:
  using RequiredInputs = typed_field::Inputs<Required>;
  using OptionalInputs = typed_field::Inputs<Optional>;

  bool acceptsInput(const Field& from, std::size_t index, std::string& why) const override {
    if (RequiredInputs::kOpenEnded || index < RequiredInputs::kCount)
      return accepts<RequiredInputs>(from, index, why);
    const std::size_t extra = index - RequiredInputs::kCount;
    if (OptionalInputs::kOpenEnded || extra < OptionalInputs::kCount)
      return accepts<OptionalInputs>(from, extra, why);
    why = "no input number " + std::to_string(index + 1);
    return false;
  }

  /// Inputs move up when one before them is unrouted: each has to fit its place still.
  void checkInputs() const override {
    const std::size_t has = this->routes_in.size();
    std::string expected;
    for (std::size_t i = 0; i < has; ++i)
      if (!acceptsInput(*this->routes_in[i], i, expected))
        throw MissingInputError(this->getFullName() + " has a " +
                                std::string(this->routes_in[i]->getTypeName()) + " as input number " +
                                std::to_string(i + 1) + " where " + expected + " is expected");
    if (has < RequiredInputs::kCount)
      throw MissingInputError(this->getFullName() + " has " + std::to_string(has) + " of " +
                              std::to_string(RequiredInputs::kCount) + " inputs: the next is a " +
                              RequiredInputs::expected(has));
  }

 private:
  template <class Inputs>
  static bool accepts(const Field& from, std::size_t index, std::string& why) {
    if (Inputs::matches(index, from)) return true;
    why = Inputs::expected(index);
    return false;
  }
};

}  // namespace pleura
