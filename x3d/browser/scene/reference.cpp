#include <fmt/format.h>

#include <pleura/fields/range_text.h>
#include <pleura/x3d/browser/scene/reference.h>
#include <pleura/x3d/encoding/xml_text.h>

namespace pleura {

namespace {

std::string escaped(std::string_view text, char what, std::string_view by) {
  std::string out;
  for (const char c : text) c == what ? void(out += by) : void(out += c);
  return out;
}

}  // namespace

std::string referenceAsList(const std::vector<const NodeType*>& types) {
  std::string out;
  for (const auto* type : types)
    out += fmt::format("{:<26} {:<22} {}\n", type->name(), type->component(), type->meaning());
  return out;
}

std::string referenceAsText(const NodeType& type) {
  std::string out = fmt::format("{} ({} {}, in {})\n  {}\n", type.name(), type.component(), type.level(),
                                type.containerField(), type.meaning());
  for (const auto& field : type.fields()) {
    out += fmt::format("  {:<11} {:<14} {:<22} {}", name(field->type), name(field->access), field->name,
                       field->defaultText);
    if (field->unit != Unit::none) out += fmt::format(" [{}]", symbol(field->unit));
    if (const auto within = rangeText(*field); !within.empty()) out += fmt::format(" ({})", within);
    if (!field->meaning.empty()) out += fmt::format("\n{:42}{}", "", field->meaning);
    out += "\n";
  }
  return out;
}

std::string referenceAsMarkdown(const std::vector<const NodeType*>& types) {
  std::string out;
  for (const auto* type : types) {
    out += fmt::format("## {}\n\n{} Component {} {}, containerField `{}`.\n\n", type->name(),
                       type->meaning().empty() ? "" : type->meaning() + ".", type->component(), type->level(),
                       type->containerField());
    out += "| field | type | access | default | unit | range | meaning |\n|---|---|---|---|---|---|---|\n";
    for (const auto& field : type->fields())
      out += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", field->name, name(field->type),
                         name(field->access), escaped(field->defaultText, '|', "\\|"), symbol(field->unit),
                         rangeText(*field), field->meaning);
    out += "\n";
  }
  return out;
}

std::string referenceAsXsd(const std::vector<const NodeType*>& types) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xs:schema "
      "xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n";
  for (const auto* type : types) {
    out += fmt::format(
        "  <xs:element name=\"{}\">\n    <xs:complexType>\n      <xs:sequence>\n"
        "        <xs:any minOccurs=\"0\" maxOccurs=\"unbounded\" processContents=\"lax\"/>\n"
        "      </xs:sequence>\n",
        type->name());
    for (const auto* reserved : {"DEF", "USE", "containerField", "class", "id", "style"})
      out += fmt::format("      <xs:attribute name=\"{}\" type=\"xs:string\"/>\n", reserved);
    for (const auto& field : type->fields()) {
      const bool isState = field->access == Access::inputOutput || field->access == Access::initializeOnly;
      if (!isState || singleOf(field->type) == FieldType::SFNode) continue;
      const bool isReserved = field->name == "class" || field->name == "id" || field->name == "style";
      if (isReserved) continue;
      out += fmt::format("      <xs:attribute name=\"{}\" type=\"xs:string\" default=\"{}\"/>\n", field->name,
                         xmlText(field->defaultText, '"'));
    }
    out += "    </xs:complexType>\n  </xs:element>\n";
  }
  return out + "</xs:schema>\n";
}

}  // namespace pleura
