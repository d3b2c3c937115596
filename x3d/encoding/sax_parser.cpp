#include <algorithm>
#include <cfenv>
#include <limits>
#include <memory>
#include <mutex>
#include <string>

#include <fmt/format.h>
#include <libxml/SAX2.h>
#include <libxml/parser.h>
#include <libxml/parserInternals.h>

#include <pleura/x3d/encoding/sax_parser.h>

namespace pleura {

std::string_view valueOf(const std::vector<Attribute>& attributes, std::string_view name) {
  for (const auto& attribute : attributes)
    if (attribute.name == name) return attribute.value;
  return {};
}

namespace {

struct Parse {
  const SourceText& source;
  ElementHandler& handler;
  Diagnostics& diagnostics;
  int deepest;
  xmlParserCtxt* parser = nullptr;
  int depth = 0;
  bool toldDepth = false;
  std::vector<Attribute> attributes;
};

std::string_view view(const xmlChar* text) { return reinterpret_cast<const char*>(text); }

std::size_t consumed(const Parse& parse) {
  return static_cast<std::size_t>(std::max(0L, xmlByteConsumed(parse.parser)));
}

/// The text with a space for each line end and tab. XML has them read as spaces in an attribute, and nothing
/// else is read here; but libxml2 takes five times as long over a value that has them. "\r\n" is one space to
/// XML, and left to it; so is text of two bytes a character.
std::string inOneLine(const std::string& text) {
  std::string line = text;
  if (text.substr(0, 4).find('\0') != std::string::npos) return line;
  std::transform(text.begin() + 1, text.end(), text.begin(), line.begin() + 1,
                 [](char c, char before) { return c == '\t' || (c == '\n' && before != '\r') ? ' ' : c; });
  return line;
}

/// libxml2 gives five pointers an attribute: local name, prefix, URI, begin and end of the value.
void onStart(void* user, const xmlChar* name, const xmlChar*, const xmlChar*, int, const xmlChar**, int count,
             int, const xmlChar** given) {
  auto& parse = *static_cast<Parse*>(user);
  const std::size_t end = consumed(parse);
  if (++parse.depth > parse.deepest) {
    if (!parse.toldDepth)
      parse.diagnostics.error(
          parse.source.placeAt(parse.source.tagBefore(end)),
          fmt::format("elements are nested more than {} deep: what is below is left out", parse.deepest));
    parse.toldDepth = true;
    return;
  }
  parse.attributes.clear();
  for (int i = 0; i < count; ++i, given += 5) {
    if (given[1] != nullptr) continue;  // of another namespace
    const auto* begin = reinterpret_cast<const char*>(given[3]);
    parse.attributes.push_back({view(given[0]), {begin, static_cast<std::size_t>(given[4] - given[3])}});
  }
  parse.handler.startElement(view(name), parse.attributes, end);
}

void onEnd(void* user, const xmlChar*, const xmlChar*, const xmlChar*) {
  auto& parse = *static_cast<Parse*>(user);
  if (parse.depth-- <= parse.deepest) parse.handler.endElement();
}

void onError(void* user, xmlError* error) {
  auto& parse = *static_cast<Parse*>(user);
  // SAX parsing without a tree has no namespaces in scope to check, and X3D has none.
  if (error->domain == XML_FROM_NAMESPACE) return;
  std::string message = error->message != nullptr ? error->message : "not well-formed";
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  const Place place = parse.source.placeAt(consumed(parse));
  if (error->level <= XML_ERR_WARNING) return parse.diagnostics.warn(place, "XML: " + message);
  parse.diagnostics.error(place, "XML: " + message);
}

/// libxml2 makes itself a NaN by dividing by zero, which the caller may have trapped.
void initializeLibxml() {
  static std::once_flag once;
  std::call_once(once, [] {
    std::fenv_t callers;
    std::feholdexcept(&callers);
    xmlInitParser();
    std::fesetenv(&callers);
  });
}

}  // namespace

void parseXml(const SourceText& source, ElementHandler& handler, Diagnostics& diagnostics, int deepest) {
  initializeLibxml();
  const std::string& text = source.text();
  if (text.empty()) return diagnostics.error({source.name()}, "is empty");
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    return diagnostics.error({source.name()}, "larger than 2 GB");

  Parse parse{source, handler, diagnostics, deepest, nullptr, 0, false, {}};
  xmlSAXHandler sax{};
  sax.initialized = XML_SAX2_MAGIC;
  sax.startElementNs = onStart;
  sax.endElementNs = onEnd;
  sax.serror = onError;
  sax.getEntity = [](void*, const xmlChar* name) { return xmlGetPredefinedEntity(name); };

  const std::unique_ptr<xmlParserCtxt, void (*)(xmlParserCtxt*)> parser(
      xmlCreateMemoryParserCtxt(inOneLine(text).data(), static_cast<int>(text.size())), xmlFreeParserCtxt);
  if (!parser) throw std::bad_alloc();
  parse.parser = parser.get();
  *parser->sax = sax;
  // Without NOENT "&amp;" would come as "&#38;"; a file's own entities are not known, and so not expanded.
  xmlCtxtUseOptions(parser.get(), XML_PARSE_NONET | XML_PARSE_HUGE | XML_PARSE_BIG_LINES | XML_PARSE_NOENT);
  parser->userData = &parse;
  // libxml2 compares each attribute of an element with every other: names without end would take for ever.
  constexpr std::size_t kBytesOfNames = 1 << 17;
  xmlDictSetLimit(parser->dict, kBytesOfNames);
  xmlParseDocument(parser.get());
}

}  // namespace pleura
