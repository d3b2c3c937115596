#pragma once

#include <string_view>
#include <vector>

#include <pleura/x3d/encoding/diagnostics.h>
#include <pleura/x3d/encoding/source_text.h>

namespace pleura {

struct Attribute {
  std::string_view name;
  std::string_view value;  // entities resolved, white space as XML has it
};

/// Empty when there is none of that name.
std::string_view valueOf(const std::vector<Attribute>& attributes, std::string_view name);

/// Hears the elements of a file in their order. `end` is the byte after the start tag, for diagnostics.
class ElementHandler {
 public:
  virtual ~ElementHandler() = default;
  virtual void startElement(std::string_view name, const std::vector<Attribute>& attributes,
                            std::size_t end) = 0;
  virtual void endElement() = 0;
};

/// Parses with libxml2's SAX interface: no tree is built, nothing but the given text is read, no network, no
/// external entity. What is not well-formed is an error among the diagnostics, and parsing ends there.
/// Elements below `deepest` are told once and skipped.
void parseXml(const SourceText& source, ElementHandler& handler, Diagnostics& diagnostics,
              int deepest = 1000);

}  // namespace pleura
