#include <algorithm>

#include <fmt/format.h>

#include <pleura/fields/errors.h>
#include <pleura/fields/nearest_name.h>
#include <pleura/nodes/standard/core/x3d_bindable_node.h>
#include <pleura/nodes/standard/networking/inline.h>
#include <pleura/x3d/encoding/document_builder.h>

namespace pleura {

namespace {

/// Attributes that any node element may have and that are no fields, unless the node has one of that name.
bool isReserved(std::string_view name) {
  constexpr std::string_view kReserved[] = {"DEF", "USE", "containerField", "class", "id", "style"};
  return std::find(std::begin(kReserved), std::end(kReserved), name) != std::end(kReserved);
}

/// What stands there in a value, for messages.
std::string wordAt(std::string_view text, std::size_t offset) {
  text = text.substr(std::min(offset, text.size()));
  text = text.substr(0, text.find_first_of(" ,\n\t\r"));
  if (text.empty()) return "nothing";
  constexpr std::size_t kMost = 24;
  return "\"" + std::string(text.substr(0, kMost)) + (text.size() > kMost ? "..." : "") + "\"";
}

}  // namespace

void DocumentBuilder::warn(std::size_t offset, std::string message) {
  reader_.diagnostics_.warn(source_.placeAt(offset), std::move(message));
}

void DocumentBuilder::error(std::size_t offset, std::string message) {
  reader_.diagnostics_.error(source_.placeAt(offset), std::move(message));
}

void DocumentBuilder::startElement(std::string_view name, const Attributes& attributes, std::size_t end) {
  const bool isSkipped = !open_.empty() && open_.back().kind == Open::Kind::skipped;
  // The place is only looked for when something is to be said of it: until then the end of the tag stands for
  // it.
  open_.push_back(isSkipped ? Open{Open::Kind::skipped} : open(name, attributes, end));
}

DocumentBuilder::Open DocumentBuilder::open(std::string_view name, const Attributes& attributes,
                                            std::size_t tag) {
  if (name == "X3D" || name == "head" || name == "Scene") {
    if (name != "X3D") return {};
    if (const auto version = valueOf(attributes, "version"); !version.empty()) document_.version = version;
    if (const auto profile = valueOf(attributes, "profile"); !profile.empty()) document_.profile = profile;
    return {};
  }
  if (openStatement(name, attributes, tag)) return {Open::Kind::statement};
  return openNode(name, attributes, tag);
}

bool DocumentBuilder::openStatement(std::string_view name, const Attributes& attributes, std::size_t tag) {
  if (name == "ROUTE") return addRoute(attributes, tag), true;
  if (name == "meta") {
    document_.meta.emplace_back(valueOf(attributes, "name"), valueOf(attributes, "content"));
    return true;
  }
  if (name == "component") return addComponent(attributes), true;
  if (name == "unit") return addUnit(attributes, tag), true;
  if (name == "IMPORT") return addImport(attributes, tag), true;
  if (name == "EXPORT") return addExport(attributes, tag), true;
  if (name == "ImportLibrary") return importLibrary(attributes, tag), true;
  return false;
}

DocumentBuilder::Open DocumentBuilder::openNode(std::string_view name, const Attributes& attributes,
                                                std::size_t tag) {
  if (const auto use = valueOf(attributes, "USE"); !use.empty()) return useNode(use, attributes, tag);
  const NodeType* type = reader_.registry_.find(name);
  if (type == nullptr) {
    if (told_.insert(std::string(name)).second)
      warn(source_.tagBefore(tag), fmt::format("unknown node {}: left out with what it contains{}", name,
                                               didYouMean(nearestType(name))));
    return {Open::Kind::skipped};
  }
  Open opened{Open::Kind::node, type->create(), type->containerField(), tag};
  const auto [line, column] = source_.lineAndColumn(source_.tagBefore(tag));
  opened.node->setPlace({file_, line, column});
  if (const auto field = valueOf(attributes, "containerField"); !field.empty()) opened.containerField = field;
  if (const auto def = valueOf(attributes, "DEF"); !def.empty()) define(std::string(def), opened.node, tag);
  setFields(*opened.node, attributes, tag);
  return opened;
}

void DocumentBuilder::define(const std::string& def, const NodePtr& node, std::size_t tag) {
  if (!document_.names.emplace(def, node).second) {
    warn(source_.attributeValue(source_.tagBefore(tag), "DEF"),
         fmt::format("DEF {} is given twice: the later node keeps no name", def));
    return;
  }
  node->setName(def);
}

DocumentBuilder::Open DocumentBuilder::useNode(std::string_view def, const Attributes& attributes,
                                               std::size_t tag) {
  const std::size_t at = source_.tagBefore(tag);
  const auto found = document_.names.find(def);
  if (found == document_.names.end()) {
    error(source_.attributeValue(at, "USE"), fmt::format("USE {}: no node of that name stands before{}", def,
                                                         didYouMean(nearestNode(def, document_.names))));
    return {Open::Kind::skipped};
  }
  const bool isOpen =
      std::any_of(open_.begin(), open_.end(), [&](const Open& o) { return o.node == found->second; });
  if (isOpen) {
    error(source_.attributeValue(at, "USE"), fmt::format("USE {}: a node can't contain itself", def));
    return {Open::Kind::skipped};
  }
  Open opened{Open::Kind::node, found->second, found->second->type().containerField(), tag, true};
  if (const auto field = valueOf(attributes, "containerField"); !field.empty()) opened.containerField = field;
  return opened;
}

void DocumentBuilder::setFields(Node& node, const Attributes& attributes, std::size_t tag) {
  for (const auto& attribute : attributes)
    if (!isReserved(attribute.name) || node.type().find(attribute.name) != nullptr)
      setField(node, attribute, tag);
}

void DocumentBuilder::setField(Node& node, const Attribute& attribute, std::size_t tag) {
  const NodeType& type = node.type();
  const NodeField* declared = type.find(attribute.name);
  if (declared == nullptr || declared->name != attribute.name) {
    std::vector<std::string_view> known;
    for (const auto& field : type.fields()) known.push_back(field->name);
    warn(source_.attributeValue(source_.tagBefore(tag), attribute.name),
         fmt::format("{} has no field {}{}", node.describe(), attribute.name,
                     didYouMean(nearestName(attribute.name, known))));
    return;
  }
  const auto where = [&](std::size_t offset) {
    return source_.attributeValue(source_.tagBefore(tag), attribute.name) + offset;
  };
  Field& field = declared->of(node);
  try {
    field.setValueFromString(attribute.value, nullptr, scaleOf(*declared));
    if (declared->type == FieldType::MFString && isUnquoted(attribute.value) &&
        told_.insert("unquoted").second)
      warn(where(0), fmt::format("{}.{}: read as one string; strings of a list stand in double quotes",
                                 node.describe(), declared->name));
  } catch (const FieldParseError& bad) {
    error(where(bad.offset),
          fmt::format("{}.{}: expected {} ({}), found {}", node.describe(), declared->name, bad.what(),
                      name(declared->type),
                      bad.found.empty() ? wordAt(attribute.value, bad.offset) : bad.found));
  } catch (const FieldAccessError&) {
    error(where(0), fmt::format("{}.{} is {}: a file can't give it a value", node.describe(), declared->name,
                                name(declared->access)));
  }
}

void DocumentBuilder::endElement() {
  const Open closed = std::move(open_.back());
  open_.pop_back();
  if (closed.kind == Open::Kind::node) closeNode(closed);
}

void DocumentBuilder::closeNode(const Open& closed) {
  if (!closed.isUse) {
    extents_.try_emplace(closed.node.get());
    if (dynamic_cast<Inline*>(closed.node.get()) != nullptr) loadInline(closed);
    closed.node->initialize(reader_.context_);
    bindFirst(*closed.node);
  }
  place(closed);
}

/// What the file itself has of a kind comes before what its Inlines have bound (X3D 7.2.2).
void DocumentBuilder::bindFirst(Node& node) {
  auto* bindable = dynamic_cast<X3DBindableNode*>(&node);
  if (bindable == nullptr || reader_.inlines_ > 0) return;
  if (kindsBound_.emplace(bindable->kind()).second) bindable->set_bind.setValue(true);
}

void DocumentBuilder::place(const Open& child) {
  const auto parent =
      std::find_if(open_.rbegin(), open_.rend(), [](const Open& o) { return o.kind == Open::Kind::node; });
  if (parent == open_.rend()) {
    document_.nodes.push_back(child.node);
    return;
  }
  Node& into = *parent->node;
  const auto where = [&] { return source_.tagBefore(child.tag); };
  const NodeField* declared = into.type().find(child.containerField);
  Field* field = declared != nullptr ? &declared->of(into) : nullptr;
  auto* single = dynamic_cast<SFNode*>(field);
  auto* multi = dynamic_cast<MFNode*>(field);
  if (single == nullptr && multi == nullptr)
    return error(where(), fmt::format("{} has no field {} for a node: {} is left out", into.describe(),
                                      child.containerField, child.node->describe()));
  if (single != nullptr ? !single->admits(*child.node) : !multi->admits(*child.node))
    return error(where(), fmt::format("{}.{} takes no {}: left out", into.describe(), child.containerField,
                                      child.node->type().name()));
  const Extent extent = extents_[child.node.get()];
  Extent& grown = extents_[&into];
  const Extent wouldBe{std::max(grown.depth, extent.depth + 1), grown.nodes + extent.nodes};
  if (wouldBe.depth > reader_.limits_.depth || wouldBe.nodes > reader_.limits_.expandedNodes)
    return error(
        where(),
        fmt::format(
            "{}: with every USE counted the scene is too large or too deep ({} nodes, {} levels): left out",
            child.node->describe(), wouldBe.nodes, wouldBe.depth));
  grown = wouldBe;
  if (single != nullptr) {
    if (single->getValue(into.id))
      warn(where(), fmt::format("{}.{} has a node already: {} takes its place", into.describe(),
                                child.containerField, child.node->describe()));
    single->setValue(child.node, into.id);
  } else {
    multi->push_back(child.node, into.id);
  }
}

double DocumentBuilder::scaleOf(const FieldDeclaration& field) const {
  const auto factor = [&](std::string_view category) {
    const auto found = unitFactors_.find(category);
    return found != unitFactors_.end() ? found->second : 1.0;
  };
  if (unitFactors_.empty()) return 1;
  switch (field.unit) {
    case Unit::length:
    case Unit::speed:
      return factor("length");
    case Unit::area:
      return factor("length") * factor("length");
    case Unit::volume:
    case Unit::volumeFlow:
      return factor("length") * factor("length") * factor("length");
    case Unit::angle:
      return factor("angle");
    case Unit::mass:
      return factor("mass");
    case Unit::force:
      return factor("force");
    case Unit::pressure:
      return factor("force") / (factor("length") * factor("length"));
    case Unit::density:
      return factor("mass") / (factor("length") * factor("length") * factor("length"));
    case Unit::none:
    case Unit::time:
    case Unit::perMinute:
    case Unit::frequency:
      return 1;
  }
  return 1;
}

std::string DocumentBuilder::nearestType(std::string_view name) const {
  return reader_.diagnostics_.isFull() ? std::string() : reader_.registry_.nearest(name);
}

std::string DocumentBuilder::nearestNode(std::string_view def, const Names& among) const {
  constexpr std::size_t kMostSearched = 10000;
  if (reader_.diagnostics_.isFull() || among.size() > kMostSearched) return {};
  std::vector<std::string_view> known;
  for (const auto& [name, node] : among) known.push_back(name);
  return nearestName(def, known);
}

}  // namespace pleura
