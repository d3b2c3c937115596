#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <pleura/nodes/core/node_registry.h>
#include <pleura/nodes/core/plugin.h>
#include <pleura/nodes/core/scene_context.h>
#include <pleura/x3d/encoding/diagnostics.h>
#include <pleura/x3d/encoding/document.h>
#include <pleura/x3d/encoding/source_text.h>

namespace pleura {

/// What a file may do and how large it may get.
struct ReaderLimits {
  bool outsideFolder = false;            // Inlines may leave the first file's folder
  std::filesystem::path anatomyFolder;   // where "anatomy/..." is looked for instead; empty: beside the file
  int depth = 1000;                      // of elements, and of nodes through USE
  int inlineDepth = 16;                  // of files that inline files
  std::size_t expandedNodes = 20000000;  // counting each USE as a copy
};

/// Reads X3D's XML encoding (ISO/IEC 19776-1) into nodes, routes set up and nodes initialized. Whatever is at
/// fault in the file is told to `diagnostics`, and the rest goes on; nothing is thrown.
class Reader {
 public:
  Reader(NodeRegistry& registry, PluginLoader& plugins, SceneContext& context, Diagnostics& diagnostics,
         ReaderLimits limits = {})
      : registry_(registry),
        plugins_(plugins),
        context_(context),
        diagnostics_(diagnostics),
        limits_(std::move(limits)) {}

  /// A file that can't be read is an error among the diagnostics, and an empty document.
  Document readFile(const std::filesystem::path& file);
  /// Inlines are looked for in `folder`.
  Document readText(const SourceText& source, const std::filesystem::path& folder);

 private:
  friend class DocumentBuilder;

  NodeRegistry& registry_;
  PluginLoader& plugins_;
  SceneContext& context_;
  Diagnostics& diagnostics_;
  ReaderLimits limits_;
  std::filesystem::path root_;                  // nothing outside is read
  std::vector<std::filesystem::path> reading_;  // the files on the way to the present one
  int inlines_ = 0;                             // around what is read now
};

}  // namespace pleura
