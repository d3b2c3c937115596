#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <pleura/x3d/encoding/document.h>
#include <pleura/x3d/encoding/reader.h>
#include <pleura/x3d/encoding/sax_parser.h>

namespace pleura {

/// Makes a Document from the elements of one file.
class DocumentBuilder : public ElementHandler {
 public:
  DocumentBuilder(Reader& reader, const SourceText& source, std::filesystem::path folder)
      : reader_(reader), source_(source), folder_(std::move(folder)) {}

  void startElement(std::string_view name, const std::vector<Attribute>& attributes,
                    std::size_t end) override;
  void endElement() override;

  /// To be called once, after the last element: makes the routes.
  Document finish();

 private:
  using Attributes = std::vector<Attribute>;
  using Names = std::map<std::string, NodePtr, std::less<>>;

  /// An element that is open.
  struct Open {
    enum class Kind { structure, statement, node, skipped };
    Kind kind = Kind::structure;
    NodePtr node = nullptr;  // Kind::node
    std::string containerField = {};
    std::size_t tag = 0;  // where it stands
    bool isUse = false;
  };

  /// How far a node reaches below itself, each USE counted as a copy.
  struct Extent {
    int depth = 1;
    std::size_t nodes = 1;
  };

  struct PendingRoute {
    RouteStatement route;
    std::size_t tag;
  };

  Open open(std::string_view name, const Attributes& attributes, std::size_t tag);
  bool openStatement(std::string_view name, const Attributes& attributes, std::size_t tag);
  Open openNode(std::string_view name, const Attributes& attributes, std::size_t tag);
  Open useNode(std::string_view def, const Attributes& attributes, std::size_t tag);
  void setFields(Node& node, const Attributes& attributes, std::size_t tag);
  void setField(Node& node, const Attribute& attribute, std::size_t tag);
  void define(const std::string& def, const NodePtr& node, std::size_t tag);

  void closeNode(const Open& closed);
  void bindFirst(Node& node);
  void place(const Open& child);
  void grow(const NodePtr& parent, const Open& child);
  void loadInline(const Open& opened);

  void addComponent(const Attributes& attributes);
  void addUnit(const Attributes& attributes, std::size_t tag);
  void addRoute(const Attributes& attributes, std::size_t tag);
  void addImport(const Attributes& attributes, std::size_t tag);
  void addExport(const Attributes& attributes, std::size_t tag);
  void importLibrary(const Attributes& attributes, std::size_t tag);
  void makeRoute(const PendingRoute& pending);
  Field* routeEnd(const std::string& nodeName, const std::string& fieldName, std::size_t tag);

  double scaleOf(const FieldDeclaration& field) const;
  // For "did you mean": nothing where nobody would see it, or the search would take long.
  std::string nearestNode(std::string_view def, const Names& among) const;
  std::string nearestType(std::string_view name) const;
  void warn(std::size_t offset, std::string message);
  void error(std::size_t offset, std::string message);

  Reader& reader_;
  const SourceText& source_;
  const std::shared_ptr<const std::string> file_ = std::make_shared<const std::string>(source_.name());
  std::filesystem::path folder_;
  Document document_;
  std::vector<Open> open_;
  std::vector<PendingRoute> routes_;
  std::unordered_map<const Node*, Extent> extents_;
  std::unordered_map<const Node*, Names> inlined_;  // what each Inline's file exports
  std::map<std::string, double, std::less<>> unitFactors_;
  std::set<std::string, std::less<>> told_;        // what is warned of once a file
  std::set<std::string, std::less<>> kindsBound_;  // of bindable nodes, the first of each
};

}  // namespace pleura
