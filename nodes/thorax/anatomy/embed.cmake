# cmake -DTABLES=a.csv;b.csv -DOUTPUT=x.cpp -P embed.cmake: every line of every table as a string literal.
set(arrays "")
set(entries "")
foreach(table ${TABLES})
  get_filename_component(name ${table} NAME_WE)
  file(READ ${table} text)
  string(REGEX REPLACE "([^\n]+)\n" "    R\"(\\1)\",\n" lines "${text}")
  string(APPEND arrays "constexpr std::string_view ${name}[] = {\n${lines}};\n\n")
  string(APPEND entries "  if (name == \"${name}\") return ${name};\n")
endforeach()
file(WRITE ${OUTPUT} "#include <pleura/nodes/thorax/anatomy/measurements.h>

namespace pleura {
namespace {

${arrays}}  // namespace

std::span<const std::string_view> measurementLines(std::string_view name) {
${entries}  return {};
}

}  // namespace pleura
")
