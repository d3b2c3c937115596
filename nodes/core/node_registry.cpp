#include <algorithm>
#include <numeric>

#include <pleura/nodes/core/node_registry.h>

namespace pleura {

void NodeRegistry::add(const NodeType& type) {
  if (!byName_.emplace(type.name(), &type).second)
    throw DuplicateTypeError("node type " + type.name() + " is registered twice");
}

void NodeRegistry::addAlias(const std::string& alias, const std::string& type) {
  if (!byName_.emplace(alias, byName_.at(type)).second)
    throw DuplicateTypeError("node type " + alias + " is registered twice");
}

const NodeType* NodeRegistry::find(std::string_view name) const {
  const auto found = byName_.find(name);
  return found != byName_.end() ? found->second : nullptr;
}

std::string NodeRegistry::nearest(std::string_view name) const {
  std::vector<std::string_view> known;
  for (const auto& [each, type] : byName_) known.push_back(each);
  return nearestName(name, known);
}

std::vector<const NodeType*> NodeRegistry::types() const {
  std::vector<const NodeType*> all;
  for (const auto& [name, type] : byName_)
    if (type->name() == name) all.push_back(type);
  return all;
}

namespace {

/// Levenshtein's distance, letters' case ignored.
std::size_t editDistance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 'a' - 'A') : c; };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i]) != lower(b[j]) ? 1 : 0);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearestName(std::string_view name, const std::vector<std::string_view>& known) {
  constexpr std::size_t kLongest = 64;
  if (name.size() > kLongest) return {};
  std::string_view best;
  std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const auto each : known) {
    const std::size_t distance = editDistance(name, each);
    if (distance >= least) continue;
    least = distance;
    best = each;
  }
  return std::string(best);
}

std::string didYouMean(const std::string& nearest) {
  return nearest.empty() ? std::string() : "; did you mean " + nearest + "?";
}

}  // namespace pleura
