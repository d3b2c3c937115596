#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace pleura {

/// Something that was asked of a field and can't be done. The message names the field.
struct FieldError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Setting what may not be set, or reading what may not be read.
struct FieldAccessError : FieldError {
  using FieldError::FieldError;
};

/// A route between fields whose types or access types do not fit, or one input too many. Nothing was changed.
struct RouteError : FieldError {
  using FieldError::FieldError;
};

/// A TypedField was evaluated without the inputs that it requires.
struct MissingInputError : FieldError {
  using FieldError::FieldError;
};

/// Text that is no value of the field's type. `offset` is where in the text, in bytes; `found` is what was
/// there instead, empty where it is the word at that place.
struct FieldParseError : FieldError {
  FieldParseError(const std::string& expected, std::size_t at, std::string instead = {})
      : FieldError(expected), offset(at), found(std::move(instead)) {}
  std::size_t offset;
  std::string found;
};

}  // namespace pleura
