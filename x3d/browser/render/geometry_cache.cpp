#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <pleura/x3d/browser/render/geometry_cache.h>

namespace pleura::render {
namespace {

constexpr std::size_t indicesPerPrimitive(Primitive primitive) {
  return primitive == Primitive::Triangles ? 3 : primitive == Primitive::Lines ? 2 : 1;
}

constexpr GLenum glPrimitive(Primitive primitive) {
  return primitive == Primitive::Triangles ? GL_TRIANGLES
         : primitive == Primitive::Lines   ? GL_LINES
                                           : GL_POINTS;
}

void checkCount(const char* name, std::size_t count, std::size_t positions) {
  if (count != 0 && count != positions)
    throw std::invalid_argument(
        fmt::format("geometry.{} has {} values for {} positions", name, count, positions));
}

}  // namespace

GpuGeometry::GpuGeometry(const GlFunctions& gl)
    : gl_(gl),
      vertexArray_(gl),
      positions_{GlBuffer(gl)},
      normals_{GlBuffer(gl)},
      colors_{GlBuffer(gl)},
      indices_{GlBuffer(gl)} {}

int GpuGeometry::update(const Geometry& geometry) {
  checkCount("normals", geometry.normals.size(), geometry.positions.size());
  checkCount("colors", geometry.colors.size(), geometry.positions.size());
  gl_.BindVertexArray(vertexArray_);
  const bool colorsChanged = changed(colors_, geometry.colors, geometry.colorsRevision);
  const int sent = sendVertices(positions_, geometry.positions, geometry.positionsRevision, 0, "positions") +
                   sendVertices(normals_, geometry.normals, geometry.normalsRevision, 1, "normals") +
                   sendVertices(colors_, geometry.colors, geometry.colorsRevision, 2, "colors") +
                   sendIndices(geometry);
  if (colorsChanged)
    translucent_ = std::ranges::any_of(geometry.colors, [](const auto& c) { return c.w() < 1; });
  if (indices_.size > 0 && largestIndex_ >= positions_.size)
    throw std::invalid_argument(
        fmt::format("geometry.indices has {}, but there are {} positions", largestIndex_, positions_.size));
  return sent;
}

template <class Value>
bool GpuGeometry::changed(const Stream& stream, std::span<const Value> values, std::uint64_t revision) const {
  return stream.size != values.size() || stream.revision != revision || !stream.sent;
}

template <class Value>
bool GpuGeometry::sendVertices(Stream& stream, std::span<const Value> values, std::uint64_t revision,
                               GLuint attribute, const char* name) {
  if (!changed(stream, values, revision)) return false;
  for (const Value& value : values)
    if (!value.allFinite())
      throw std::invalid_argument(fmt::format("geometry.{} holds a value that is not finite", name));
  gl_.BindBuffer(GL_ARRAY_BUFFER, stream.buffer);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size_bytes()), values.data(),
                 GL_STREAM_DRAW);
  gl_.VertexAttribPointer(attribute, Value::RowsAtCompileTime, GL_FLOAT, GL_FALSE, 0, nullptr);
  (values.empty() ? gl_.DisableVertexAttribArray : gl_.EnableVertexAttribArray)(attribute);
  stream.revision = revision;
  stream.size = values.size();
  stream.sent = true;
  return !values.empty();
}

bool GpuGeometry::sendIndices(const Geometry& geometry) {
  const auto indices = geometry.indices;
  if (!changed(indices_, indices, geometry.indicesRevision)) return false;
  if (indices.size() % indicesPerPrimitive(geometry.primitive) != 0)
    throw std::invalid_argument(fmt::format("geometry.indices has {}, no multiple of {}", indices.size(),
                                            indicesPerPrimitive(geometry.primitive)));
  const std::uint32_t largest = indices.empty() ? 0 : *std::ranges::max_element(indices);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.buffer);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(),
                 GL_STATIC_DRAW);
  indices_.revision = geometry.indicesRevision;
  indices_.size = indices.size();
  indices_.sent = true;
  largestIndex_ = largest;
  return !indices.empty();
}

void GpuGeometry::draw(Primitive primitive) const {
  gl_.BindVertexArray(vertexArray_);
  gl_.DrawElements(glPrimitive(primitive), static_cast<GLsizei>(indices_.size), GL_UNSIGNED_INT, nullptr);
}

GpuGeometry& GeometryCache::find(const Geometry& geometry) {
  const char* key = geometry.identity.get();
  if (!key) throw std::invalid_argument("geometry has been moved from");
  const auto found = entries_.find(key);
  if (found != entries_.end()) return found->second.gpu;
  return entries_.try_emplace(key, Entry{geometry.identity, GpuGeometry(gl_)}).first->second.gpu;
}

void GeometryCache::collect() {
  std::erase_if(entries_, [](const auto& entry) { return entry.second.identity.expired(); });
}

}  // namespace pleura::render
