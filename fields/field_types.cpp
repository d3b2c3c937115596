#include <pleura/fields/field_types.h>

namespace pleura {

#define PLEURA_VALUE_FIELDS(name, type)             \
  template class SField<type, FieldType::SF##name>; \
  template class MField<type, FieldType::MF##name>;
PLEURA_VALUE_TYPES(PLEURA_VALUE_FIELDS)

}  // namespace pleura
