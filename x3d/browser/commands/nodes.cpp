#include <memory>
#include <string>

#include <fmt/format.h>

#include <pleura/fields/nearest_name.h>
#include <pleura/nodes/built_in_nodes.h>
#include <pleura/nodes/core/node_registry.h>
#include <pleura/nodes/core/plugin.h>
#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/scene/reference.h>

namespace pleura {

namespace {

struct NodesOptions {
  std::string type;
  std::vector<std::string> libraries = {"thorax", "lung"};
  bool markdown = false;
  bool xsd = false;
};

void printReference(const NodesOptions& options) {
  NodeRegistry registry;
  registerBuiltInNodes(registry);
  PluginLoader plugins;
  for (const auto& library : options.libraries) plugins.load(library, registry);
  std::vector<const NodeType*> types = registry.types();
  if (!options.type.empty()) {
    const NodeType* type = registry.find(options.type);
    if (type == nullptr)
      throw Fault(fmt::format("no node type {}{}", options.type, didYouMean(registry.nearest(options.type))));
    types = {type};
  }
  if (options.xsd) return fmt::print("{}", referenceAsXsd(types));
  if (options.markdown) return fmt::print("{}", referenceAsMarkdown(types));
  fmt::print("{}", options.type.empty() ? referenceAsList(types) : referenceAsText(*types.front()));
}

}  // namespace

void addNodesCommand(CLI::App& app) {
  auto* command =
      app.add_subcommand("nodes", "Reference: node types, their fields, types, access, defaults, units");
  const auto options = std::make_shared<NodesOptions>();
  command->add_option("TYPE", options->type, "One node type");
  command->add_option("--library", options->libraries, "Plugins to load; repeat for more")
      ->allow_extra_args(false)
      ->capture_default_str();
  auto* markdown = command->add_flag("--markdown", options->markdown, "As Markdown");
  command->add_flag("--xsd", options->xsd, "As an XML schema")->excludes(markdown);
  command->callback([options] { printReference(*options); });
}

}  // namespace pleura
