#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <pleura/fields/errors.h>
#include <pleura/fields/nearest_name.h>
#include <pleura/fields/periodic_update.h>
#include <pleura/nodes/built_in_nodes.h>
#include <pleura/x3d/browser/scene/scene.h>
#include <pleura/x3d/browser/tradeoff/deformation_tier.h>
#include <pleura/x3d/browser/tradeoff/tier_figures.h>
#include <pleura/x3d/encoding/allowed_path.h>

namespace pleura {

namespace {

[[noreturn]] void refuse(const std::string& what, std::string_view name,
                         const std::vector<std::string_view>& known) {
  throw UnknownNameError(what + didYouMean(nearestName(name, known)));
}

}  // namespace

Scene::Scene() { registerBuiltInNodes(registry_); }

/// What lists every node is emptied first: each node would search it as it goes.
Scene::~Scene() {
  keyListeners_.clear();
  while (!time.getRoutesOut().empty()) time.unroute(*time.getRoutesOut().back());
}

void Scene::load(const std::filesystem::path& file, ReaderLimits limits) {
  file_ = file.string();
  limits_ = std::move(limits);
  document_ = Reader(registry_, plugins_, *this, diagnostics_, limits_).readFile(file);
}

void Scene::tick(Time now) {
  time.setValue(now);
  PeriodicFields::upToDate();
}

void Scene::key(const KeyEvent& event) {
  const auto listeners = keyListeners_;
  for (auto* listener : listeners)
    if (std::find(keyListeners_.begin(), keyListeners_.end(), listener) != keyListeners_.end())
      listener->onKey(event);
}

std::filesystem::path Scene::fileOf(const std::string& url) const {
  const auto folder = std::filesystem::path(file_).parent_path();
  const auto path = allowedPath(url, folder, std::filesystem::weakly_canonical(folder), limits_);
  if (!path) throw FileError(fmt::format("{} is outside the scene's folder, which is not allowed", url));
  return *path;
}

Node& Scene::node(std::string_view def) const {
  const auto found = document_.names.find(def);
  if (found != document_.names.end()) return *found->second;
  std::vector<std::string_view> known;
  for (const auto& [name, node] : document_.names) known.push_back(name);
  refuse(fmt::format("the scene has no node {}", def), def, known);
}

Field& Scene::field(std::string_view path) const {
  const auto dot = path.rfind('.');
  if (dot == std::string_view::npos) throw UnknownNameError(fmt::format("{}: expected DEF.field", path));
  Node& owner = node(path.substr(0, dot));
  const std::string_view name = path.substr(dot + 1);
  if (Field* found = owner.getField(name)) return *found;
  std::vector<std::string_view> known;
  for (const auto& declared : owner.type().fields()) known.push_back(declared->name);
  refuse(fmt::format("{} ({}) has no field {}", owner.describe(), owner.type().name(), name), name, known);
}

void Scene::set(std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw UnknownNameError(fmt::format("{}: expected DEF.field=VALUE", assignment));
  Field& target = field(assignment.substr(0, equals));
  try {
    target.setValueFromString(assignment.substr(equals + 1));
  } catch (const FieldParseError& bad) {
    throw FieldError(fmt::format("{}: expected {} ({}){}", assignment, bad.what(), target.getTypeName(),
                                 bad.found.empty() ? "" : ", found " + bad.found));
  }
}

NodePtr Scene::make(std::string_view type) {
  const NodeType* known = registry_.find(type);
  return known != nullptr ? known->create() : nullptr;
}

std::vector<DeformationFigure> Scene::deformationFigures() {
  std::vector<DeformationFigure> figures;
  for (const TierFigures& f : readFigures(keptFigures())) {
    if (!f.isChoosable()) continue;
    const DeformationTier tier = tierOf(f.method, f.elements);
    figures.push_back({f.organ, tier.node, tier.fields, f.error.rms, f.median});
  }
  return figures;
}

void Scene::warn(const Node& node, const std::string& message) {
  const NodePlace& at = node.place();
  const Diagnostic warning{Diagnostic::Severity::warning,
                           at.file ? Place{*at.file, at.line, at.column} : Place{file_},
                           node.describe() + ": " + message};
  if (warned_.insert(toText(warning)).second) diagnostics_.warn(warning.place, warning.message);
}

}  // namespace pleura
