#include <sstream>

#include <fmt/format.h>

#include <pleura/fields/errors.h>
#include <pleura/nodes/standard/shape/x3d_shape_node.h>
#include <pleura/x3d/browser/playback/watch_table.h>

namespace pleura {

namespace {

/// The components of a value: numbers and words of its text; a string is one, in quotes where it needs them.
std::vector<std::string> components(Field& field) {
  const std::string text = field.getValueAsString();
  if (field.getType() == FieldType::SFString || field.getType() == FieldType::MFString) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return {quoted + "\""};
  }
  std::istringstream words(text);
  std::vector<std::string> all;
  for (std::string word; words >> word;) all.push_back(word);
  return all;
}

}  // namespace

WatchTable::WatchTable(Scene& scene, const std::vector<std::string>& paths) {
  for (const auto& path : paths) {
    Field& field = scene.field(path);
    if (singleOf(field.getType()) == FieldType::SFNode)
      throw FieldError(path + " is a node: it has no numbers");
    if (!canGet(field.getAccessType())) throw FieldAccessError(path + " is inputOnly: it can't be read");
    fields_.emplace_back(path, &field);
  }
}

void WatchTable::writeHeader(std::ostream& out) {
  out << "time";
  for (const auto& [path, field] : fields_) {
    const std::size_t count = components(*field).size();
    if (count == 1) out << ',' << path;
    for (std::size_t i = 0; count > 1 && i < count; ++i) out << ',' << path << '.' << i;
  }
  out << '\n';
}

void WatchTable::writeRow(std::ostream& out, Time now) {
  for (const auto& [path, field] : fields_)
    if (auto* shape = dynamic_cast<X3DShapeNode*>(field->getOwner());
        shape != nullptr && !field->isUpToDate())
      shape->begin();
  out << fmt::format("{:.6g}", now);
  for (const auto& [path, field] : fields_)
    for (const auto& component : components(*field)) out << ',' << component;
  out << '\n';
}

}  // namespace pleura
