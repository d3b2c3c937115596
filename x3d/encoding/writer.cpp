#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

#include <pleura/nodes/core/node_type.h>
#include <pleura/x3d/encoding/writer.h>
#include <pleura/x3d/encoding/xml_text.h>

namespace pleura {

namespace {

/// With the quotes around it.
std::string attributeText(std::string_view value) { return "'" + xmlText(value) + "'"; }

class Writer {
 public:
  explicit Writer(Document& document) : document_(document) {
    for (const auto& node : document.nodes) countUses(node);
  }

  std::string write() {
    out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out_ += fmt::format("<X3D profile={} version={}>\n", attributeText(document_.profile),
                        attributeText(document_.version));
    writeHead();
    out_ += "  <Scene>\n";
    for (const auto& library : document_.libraries)
      out_ += fmt::format("    <ImportLibrary library={}/>\n", attributeText(library));
    for (const auto& node : document_.nodes) writeNode(node, node->type().containerField(), 2);
    for (const auto& [inlineName, node, as] : document_.imports)
      out_ += fmt::format("    <IMPORT inlineDEF={} importedDEF={} AS={}/>\n", attributeText(inlineName),
                          attributeText(node), attributeText(as));
    for (const auto& [def, as] : document_.exports)
      out_ += fmt::format("    <EXPORT localDEF={} AS={}/>\n", attributeText(def), attributeText(as));
    for (const auto& route : document_.routes)
      out_ += fmt::format("    <ROUTE fromNode={} fromField={} toNode={} toField={}/>\n",
                          attributeText(route.fromNode), attributeText(route.fromField),
                          attributeText(route.toNode), attributeText(route.toField));
    return out_ + "  </Scene>\n</X3D>\n";
  }

 private:
  /// Nodes below `node`, in fields' order.
  template <class Visit>
  static void forEachChild(Node& node, Visit visit) {
    for (const auto& declared : node.type().fields()) {
      if (declared->access != Access::inputOutput && declared->access != Access::initializeOnly) continue;
      Field& field = declared->of(node);
      if (auto* single = dynamic_cast<SFNode*>(&field)) {
        if (single->getValue(node.id)) visit(single->getValue(node.id), *declared);
      } else if (auto* multi = dynamic_cast<MFNode*>(&field)) {
        for (const auto& child : multi->getValue(node.id))
          if (child) visit(child, *declared);
      }
    }
  }

  void countUses(const NodePtr& node) {
    if (!node->getName().empty()) taken_.insert(node->getName());
    if (++uses_[node.get()] > 1) return;
    forEachChild(*node, [&](const NodePtr& child, const NodeField&) { countUses(child); });
  }

  std::string nameFor(Node& node) {
    if (!node.getName().empty() || uses_[&node] < 2) return node.getName();
    std::string name;
    for (int i = 1; name.empty() || taken_.contains(name); ++i)
      name = fmt::format("{}_{}", node.type().name(), i);
    taken_.insert(name);
    node.setName(name);
    return name;
  }

  void writeHead() {
    if (document_.components.empty() && document_.meta.empty()) return;
    out_ += "  <head>\n";
    for (const auto& [name, level] : document_.components)
      out_ += fmt::format("    <component name={} level='{}'/>\n", attributeText(name), level);
    for (const auto& [name, content] : document_.meta)
      out_ += fmt::format("    <meta name={} content={}/>\n", attributeText(name), attributeText(content));
    out_ += "  </head>\n";
  }

  void writeNode(const NodePtr& node, std::string_view into, int level) {
    const std::string indent(static_cast<std::size_t>(level) * 2, ' ');
    const NodeType& type = node->type();
    out_ += indent + "<" + type.name();
    const std::string name = nameFor(*node);
    const bool isUse = !written_.insert(node.get()).second;
    if (!name.empty()) out_ += (isUse ? " USE=" : " DEF=") + attributeText(name);
    if (into != type.containerField()) out_ += " containerField=" + attributeText(into);
    if (isUse) {
      out_ += "/>\n";
      return;
    }
    writeAttributes(*node);
    const std::size_t before = out_.size();
    out_ += ">\n";
    const std::size_t empty = out_.size();
    forEachChild(*node, [&](const NodePtr& child, const NodeField& field) {
      writeNode(child, field.name, level + 1);
    });
    if (out_.size() == empty) {
      out_.replace(before, 1, "/>");
    } else {
      out_ += indent + "</" + type.name() + ">\n";
    }
  }

  void writeAttributes(Node& node) {
    for (const auto& declared : node.type().fields()) {
      const bool isState =
          declared->access == Access::inputOutput || declared->access == Access::initializeOnly;
      if (!isState || singleOf(declared->type) == FieldType::SFNode) continue;
      const std::string value = declared->of(node).getValueAsString();
      if (value != declared->defaultText) out_ += " " + declared->name + "=" + attributeText(value);
    }
  }

  Document& document_;
  std::string out_;
  std::unordered_map<const Node*, int> uses_;
  std::unordered_set<const Node*> written_;
  std::unordered_set<std::string> taken_;
};

}  // namespace

std::string writeX3d(Document& document) { return Writer(document).write(); }

}  // namespace pleura
