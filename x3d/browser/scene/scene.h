#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include <pleura/nodes/core/node_registry.h>
#include <pleura/nodes/core/plugin.h>
#include <pleura/nodes/core/scene_context.h>
#include <pleura/x3d/encoding/diagnostics.h>
#include <pleura/x3d/encoding/document.h>
#include <pleura/x3d/encoding/reader.h>

namespace pleura {

/// A field of a scene was asked for by a name that it does not have. The message has the nearest one.
struct UnknownNameError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A scene that runs: its nodes, its time, its keys. One thread at a time.
class Scene : public SceneContext {
 public:
  Scene();
  ~Scene() override;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Reads the file into this scene, which must be empty. All faults are among the diagnostics.
  void load(const std::filesystem::path& file, ReaderLimits limits = {});

  /// One tick: time is set, once and first; what hears of it acts; fields that nobody reads stay out of date.
  /// `now` [s] never goes back.
  void tick(Time now);
  /// A key, told to every listener, between ticks.
  void key(const KeyEvent& event);

  /// Throws UnknownNameError.
  Node& node(std::string_view def) const;
  /// "DEF.field". Throws UnknownNameError.
  Field& field(std::string_view path) const;
  /// The value from its text, as "DEF.field=VALUE". Throws UnknownNameError, FieldError.
  void set(std::string_view assignment);

  /// The file that a node's url names, beside the scene's own file. Throws FileError when it is outside of
  /// the scene's folder, which has to be allowed.
  std::filesystem::path fileOf(const std::string& url) const;

  Document& document() { return document_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }
  const NodeRegistry& registry() const { return registry_; }

  NodePtr make(std::string_view type) override;
  std::vector<DeformationFigure> deformationFigures() override;
  void warn(const Node& node, const std::string& message) override;

 private:
  Diagnostics diagnostics_;
  NodeRegistry registry_;
  PluginLoader plugins_;
  std::string file_;
  ReaderLimits limits_;
  std::set<std::string> warned_;  // a warning that comes every tick is told once
  Document document_;             // last: its nodes may use all the others when they go
};

}  // namespace pleura
