#include <pleura/nodes/core/node_type.h>
#include <pleura/x3d/browser/scene/state_hash.h>

namespace pleura {

namespace {

void add(std::uint64_t& hash, std::string_view text) {
  constexpr std::uint64_t kPrime = 1099511628211u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
}

}  // namespace

std::uint64_t stateHash(Scene& scene) {
  std::uint64_t hash = 14695981039346656037u;
  for (const auto& [name, node] : scene.document().names) {
    add(hash, name);
    for (const auto& declared : node->type().fields()) {
      if (!canGet(declared->access) || singleOf(declared->type) == FieldType::SFNode) continue;
      add(hash, declared->name);
      add(hash, declared->of(*node).getValueAsString());
    }
  }
  return hash;
}

}  // namespace pleura
