#include <algorithm>

#include <fmt/format.h>

#include <pleura/fields/errors.h>
#include <pleura/fields/nearest_name.h>
#include <pleura/fields/text.h>
#include <pleura/nodes/standard/networking/inline.h>
#include <pleura/x3d/encoding/allowed_path.h>
#include <pleura/x3d/encoding/document_builder.h>

// The statements of a file: what is no node.
namespace pleura {

namespace {

std::string text(const std::vector<Attribute>& attributes, std::string_view name) {
  return std::string(valueOf(attributes, name));
}

}  // namespace

void DocumentBuilder::addComponent(const Attributes& attributes) {
  const std::string level = text(attributes, "level");
  document_.components.emplace_back(text(attributes, "name"), level.empty() ? 1 : std::atoi(level.c_str()));
}

void DocumentBuilder::addUnit(const Attributes& attributes, std::size_t tag) {
  UnitStatement unit{text(attributes, "category"), text(attributes, "name"), 1};
  constexpr std::string_view kCategories[] = {"angle", "force", "length", "mass"};
  const std::size_t at = source_.tagBefore(tag);
  if (std::find(std::begin(kCategories), std::end(kCategories), unit.category) == std::end(kCategories))
    return error(at,
                 fmt::format("unit: category is angle, force, length or mass, not \"{}\"", unit.category));
  try {
    const std::string factor = text(attributes, "conversionFactor");
    TextReader(factor).read(unit.factor);
  } catch (const FieldParseError&) {
    unit.factor = 0;
  }
  if (!(unit.factor > 0))
    return error(source_.attributeValue(at, "conversionFactor"),
                 "unit: conversionFactor is a number above 0");
  unitFactors_[unit.category] = unit.factor;
  document_.units.push_back(std::move(unit));
}

void DocumentBuilder::addRoute(const Attributes& attributes, std::size_t tag) {
  RouteStatement route{text(attributes, "fromNode"), text(attributes, "fromField"),
                       text(attributes, "toNode"), text(attributes, "toField")};
  document_.routes.push_back(route);
  routes_.push_back({std::move(route), tag});
}

void DocumentBuilder::addExport(const Attributes& attributes, std::size_t tag) {
  const std::string def = text(attributes, "localDEF");
  if (def.empty()) return error(source_.tagBefore(tag), "EXPORT: localDEF is missing");
  const std::string as = text(attributes, "AS");
  document_.exports.emplace_back(def, as.empty() ? def : as);
}

void DocumentBuilder::addImport(const Attributes& attributes, std::size_t tag) {
  const std::size_t at = source_.tagBefore(tag);
  ImportStatement import{text(attributes, "inlineDEF"), text(attributes, "importedDEF"),
                         text(attributes, "AS")};
  if (import.node.empty() && !text(attributes, "exportedDEF").empty()) {
    import.node = text(attributes, "exportedDEF");
    if (told_.insert("exportedDEF").second)
      warn(source_.attributeValue(at, "exportedDEF"),
           "IMPORT: exportedDEF is read as importedDEF, its standard name");
  }
  if (import.as.empty()) import.as = import.node;
  document_.imports.push_back(import);
  const auto inlineNode = document_.names.find(import.inlineName);
  const auto inner =
      inlineNode != document_.names.end() ? inlined_.find(inlineNode->second.get()) : inlined_.end();
  if (inner == inlined_.end())
    return error(source_.attributeValue(at, "inlineDEF"),
                 fmt::format("IMPORT: no Inline {} that was loaded stands before{}", import.inlineName,
                             didYouMean(nearestNode(import.inlineName, document_.names))));
  const Names& exported = inner->second;
  const auto node = exported.find(import.node);
  if (node == exported.end())
    return error(source_.attributeValue(at, "importedDEF"),
                 fmt::format("IMPORT: {} exports no {}{}", import.inlineName, import.node,
                             didYouMean(nearestNode(import.node, exported))));
  if (const auto [known, isNew] = document_.names.emplace(import.as, node->second);
      !isNew && known->second != node->second)
    warn(at, fmt::format("IMPORT: {} is the name of another node here, which keeps it", import.as));
}

void DocumentBuilder::importLibrary(const Attributes& attributes, std::size_t tag) {
  const std::size_t at = source_.tagBefore(tag);
  const std::string given =
      text(attributes, "library").empty() ? text(attributes, "url") : text(attributes, "library");
  MFString libraries;
  try {
    libraries.setValueFromString(given);
  } catch (const FieldParseError&) {
    return error(at, "ImportLibrary: library is a list of names in double quotes");
  }
  if (libraries.empty()) libraries.push_back(given);
  for (const auto& library : libraries.getValue()) {
    document_.libraries.push_back(library);
    try {
      reader_.plugins_.load(library, reader_.registry_);
    } catch (const PluginError& bad) {
      error(at, fmt::format("ImportLibrary: {}", bad.what()));
    }
  }
}

void DocumentBuilder::loadInline(const Open& opened) {
  auto& node = dynamic_cast<Inline&>(*opened.node);
  if (!node.load.getValue()) return;
  const std::size_t at = source_.attributeValue(source_.tagBefore(opened.tag), "url");
  const auto& urls = node.url.getValue();
  std::string tried;
  for (const auto& url : urls) {
    tried += (tried.empty() ? "" : ", ") + url;
    if (url.find("://") != std::string::npos) continue;
    const auto path = allowedPath(url, folder_, reader_.root_, reader_.limits_);
    if (!path)
      return error(at, fmt::format("{}.url: {} is outside the scene's folder, which is not allowed",
                                   node.describe(), url));
    std::error_code ignored;
    const auto file = std::filesystem::weakly_canonical(*path, ignored);
    if (!std::filesystem::exists(file, ignored)) continue;
    if (std::find(reader_.reading_.begin(), reader_.reading_.end(), file) != reader_.reading_.end())
      return error(at, fmt::format("{}.url: {} inlines itself", node.describe(), url));
    if (reader_.reading_.size() >= static_cast<std::size_t>(reader_.limits_.inlineDepth))
      return error(
          at, fmt::format("{}.url: {} files inline one another", node.describe(), reader_.reading_.size()));
    ++reader_.inlines_;
    Document inner = reader_.readFile(*path);
    --reader_.inlines_;
    node.contents.setValue(inner.nodes);
    Names& exported = inlined_[opened.node.get()];
    for (const auto& [def, as] : inner.exports)
      if (const auto found = inner.names.find(def); found != inner.names.end())
        exported.emplace(as, found->second);
    return;
  }
  error(at, fmt::format("{}.url: nothing to load ({})", node.describe(),
                        tried.empty() ? "no url" : tried + " not found"));
}

Field* DocumentBuilder::routeEnd(const std::string& nodeName, const std::string& fieldName, std::size_t tag) {
  const std::size_t at = source_.tagBefore(tag);
  const auto node = document_.names.find(nodeName);
  if (node == document_.names.end()) {
    error(at,
          fmt::format("ROUTE: no node {}{}", nodeName, didYouMean(nearestNode(nodeName, document_.names))));
    return nullptr;
  }
  Field* field = node->second->getField(fieldName);
  if (field == nullptr) {
    std::vector<std::string_view> known;
    for (const auto& each : node->second->type().fields()) known.push_back(each->name);
    error(at, fmt::format("ROUTE: {} ({}) has no field {}{}", nodeName, node->second->type().name(),
                          fieldName, didYouMean(nearestName(fieldName, known))));
  }
  return field;
}

void DocumentBuilder::makeRoute(const PendingRoute& pending) {
  const auto& route = pending.route;
  Field* from = routeEnd(route.fromNode, route.fromField, pending.tag);
  Field* to = routeEnd(route.toNode, route.toField, pending.tag);
  if (from == nullptr || to == nullptr) return;
  // The first event is a value that the target has missed. A switch, a time or a key that nobody has sent is
  // none.
  const FieldType kind = singleOf(from->getType());
  const bool isCommand = from->getAccessType() == Access::outputOnly &&
                         (kind == FieldType::SFBool || kind == FieldType::SFTime ||
                          kind == FieldType::SFString || kind == FieldType::SFInt32) &&
                         !isMulti(from->getType());
  try {
    isCommand ? from->routeNoEvent(*to) : from->route(*to);
  } catch (const RouteError& bad) {
    error(source_.tagBefore(pending.tag), bad.what());
  }
}

Document DocumentBuilder::finish() {
  for (const auto& pending : routes_) makeRoute(pending);
  return std::move(document_);
}

}  // namespace pleura
