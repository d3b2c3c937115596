#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>
#include <string_view>

#include <pleura/fields/errors.h>
#include <pleura/fields/field_types.h>

namespace pleura {
namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

/// Any text is a value that prints and reads back the same, or an error with its place in the text.
template <class F>
void readText(std::string_view text) {
  F field;
  try {
    field.setValueFromString(text);
  } catch (const FieldParseError& error) {
    require(error.offset <= text.size());
    return;
  }
  const std::string printed = field.getValueAsString();
  F again;
  again.setValueFromString(printed);
  require(again.getValue() == field.getValue());
  require(again.getValueAsString() == printed);
}

using Reader = void (*)(std::string_view);
constexpr Reader kReaders[] = {
#define PLEURA_FIELD_READERS(T) readText<SF##T>, readText<MF##T>,
    PLEURA_FIELD_TYPES(PLEURA_FIELD_READERS)
#undef PLEURA_FIELD_READERS
};

}  // namespace
}  // namespace pleura

/// The first byte chooses the field type, the rest is the text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  pleura::kReaders[data[0] % std::size(pleura::kReaders)](text);
  return 0;
}
