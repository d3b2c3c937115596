#pragma once

#include <string>
#include <vector>

#include <pleura/nodes/built_in_nodes.h>
#include <pleura/x3d/encoding/reader.h>

namespace pleura {

class SilentContext : public SceneContext {
 public:
  void warn(const Node&, const std::string&) override {}
};

/// A reader with all that it needs, and what it read.
struct ReadScene {
  NodeRegistry registry;
  PluginLoader plugins;
  SilentContext context;
  Diagnostics diagnostics;
  Document document;

  ReadScene() { registerBuiltInNodes(registry); }
  explicit ReadScene(const std::filesystem::path& file, const ReaderLimits& limits = {}) : ReadScene() {
    document = Reader(registry, plugins, context, diagnostics, limits).readFile(file);
  }

  /// The elements of a scene, from line 1, without X3D and Scene around them.
  static ReadScene ofElements(const std::string& elements) {
    return ofText("<Scene>" + elements + "</Scene>");
  }
  static ReadScene ofText(const std::string& text) { return ReadScene(SourceText("s.x3d", text)); }

  Field& field(const std::string& def, const std::string& name) {
    return *document.names.at(def)->getField(name);
  }
  std::string value(const std::string& def, const std::string& name) {
    return field(def, name).getValueAsString();
  }
  std::vector<std::string> said() const {
    std::vector<std::string> lines;
    for (const auto& each : diagnostics.all()) lines.push_back(toText(each));
    return lines;
  }

 private:
  explicit ReadScene(const SourceText& source) : ReadScene() {
    document = Reader(registry, plugins, context, diagnostics).readText(source, ".");
  }
};

}  // namespace pleura
