#include <algorithm>
#include <tuple>

#include <pleura/nodes/standard/rendering/vertex_layout.h>

namespace pleura {

namespace {

auto key(const Corner& corner) { return std::tie(corner.point, corner.normal, corner.color); }

}  // namespace

void VertexLayout::assign(std::span<const Corner> corners, std::span<const std::uint32_t> primitives,
                          RenderMesh& mesh) {
  std::vector<std::uint32_t> order(primitives.begin(), primitives.end());
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(key(corners[a]), a) < std::tuple(key(corners[b]), b);
  });
  vertices_.clear();
  std::vector<std::uint32_t> vertexOf(corners.size());
  std::int32_t groups = 0;
  for (const std::uint32_t corner : order) {
    if (vertices_.empty() || key(vertices_.back()) != key(corners[corner]))
      vertices_.push_back(corners[corner]);
    vertexOf[corner] = static_cast<std::uint32_t>(vertices_.size() - 1);
    groups = std::max(groups, corners[corner].normal + 1);
  }
  groups_.assign(static_cast<std::size_t>(groups), Vec3d::Zero());
  mesh.indices.resize(primitives.size());
  std::transform(primitives.begin(), primitives.end(), mesh.indices.begin(),
                 [&](std::uint32_t corner) { return vertexOf[corner]; });
}

void VertexLayout::fill(const Sources& sources, RenderMesh& mesh) {
  const std::size_t count = vertices_.size();
  mesh.positions.resize(count);
  mesh.colors.resize(sources.colors.empty() ? 0 : count);
  mesh.normals.resize(mesh.primitive == RenderMesh::Primitive::triangles ? count : 0);
  for (std::size_t i = 0; i < count; ++i)
    mesh.positions[i] = sources.points[static_cast<std::size_t>(vertices_[i].point)];
  for (std::size_t i = 0; i < mesh.colors.size(); ++i)
    mesh.colors[i] = sources.colors[static_cast<std::size_t>(vertices_[i].color)];
  if (sources.normals.empty()) return fillComputedNormals(mesh);
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    mesh.normals[i] = sources.normals[static_cast<std::size_t>(vertices_[i].normal)];
}

void VertexLayout::fillComputedNormals(RenderMesh& mesh) {
  if (mesh.normals.empty()) return;
  std::fill(groups_.begin(), groups_.end(), Vec3d::Zero());
  const auto position = [&](std::uint32_t vertex) -> Vec3d { return mesh.positions[vertex].cast<double>(); };
  const auto groupOf = [&](std::uint32_t vertex) {
    return static_cast<std::size_t>(vertices_[vertex].normal);
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t* abc = &mesh.indices[i];
    const Vec3d a = position(abc[0]);
    const Vec3d area = (position(abc[1]) - a).cross(position(abc[2]) - a);
    for (int k = 0; k < 3; ++k) groups_[groupOf(abc[k])] += area;
  }
  const double side = mesh.ccw ? 1 : -1;
  for (std::uint32_t i = 0; i < mesh.normals.size(); ++i) {
    const Vec3d& sum = groups_[groupOf(i)];
    const double length = sum.norm();
    mesh.normals[i] = length > 0 ? Vec3f((sum * (side / length)).cast<float>()) : Vec3f::UnitZ();
  }
}

}  // namespace pleura
