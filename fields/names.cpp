#include <pleura/fields/access.h>
#include <pleura/fields/field_type.h>
#include <pleura/fields/unit.h>

namespace pleura {

std::string_view name(Access access) {
  constexpr std::string_view names[] = {"inputOnly", "outputOnly", "initializeOnly", "inputOutput"};
  return names[static_cast<int>(access)];
}

std::string_view name(FieldType type) {
  constexpr std::string_view names[] = {
#define PLEURA_FIELD_TYPE(T) std::string_view("SF" #T), std::string_view("MF" #T),
      PLEURA_FIELD_TYPES(PLEURA_FIELD_TYPE)
#undef PLEURA_FIELD_TYPE
  };
  return names[static_cast<int>(type)];
}

std::string_view symbol(Unit unit) {
  constexpr std::string_view symbols[] = {"",    "m",   "rad", "s",     "kg",  "N",  "1/min",
                                          "m^2", "m^3", "Pa",  "m^3/s", "m/s", "Hz", "kg/m^3"};
  return symbols[static_cast<int>(unit)];
}

}  // namespace pleura
