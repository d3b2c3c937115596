#include <algorithm>

#include <fmt/format.h>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/standard/rendering/coordinate_geometry_node.h>
#include <pleura/nodes/standard/rendering/smoothing_groups.h>

namespace pleura {

namespace {

bool allAmong(const FaceList& faces, std::int32_t Corner::*number, std::size_t count) {
  return std::all_of(faces.corners.begin(), faces.corners.end(), [&](const Corner& corner) {
    return corner.*number >= 0 && static_cast<std::size_t>(corner.*number) < count;
  });
}

}  // namespace

std::int32_t attributeNumber(const std::vector<std::int32_t>& index, bool perVertex, std::size_t position,
                             std::size_t face, std::int32_t point) {
  if (index.empty()) return perVertex ? point : static_cast<std::int32_t>(face);
  const std::size_t at = perVertex ? position : face;
  return at < index.size() ? index[at] : -1;
}

void CoordinateGeometryNode::declare(NodeType& type) {
  X3DGeometryNode::declare(type);
  using enum Access;
  type.field<&CoordinateGeometryNode::attrib>("attrib", inputOutput, {})
      .means("attributes of vertices for shaders");
  type.field<&CoordinateGeometryNode::color>("color", inputOutput, {}).means("colours");
  type.field<&CoordinateGeometryNode::coord>("coord", inputOutput, {}).means("points");
  type.field<&CoordinateGeometryNode::fogCoord>("fogCoord", inputOutput, {})
      .means("depths of the points in fog");
  type.field<&CoordinateGeometryNode::normal>("normal", inputOutput, {}).means("normals; none: computed");
}

void CoordinateGeometryNode::updateMesh(RenderMesh& mesh) {
  const bool hasNewNodes = nodes_.changed(coord, normal, color);
  const bool hasNewTopology = topologyChanged();
  readSources();
  const std::size_t counts[] = {sources_.points.size(), sources_.normals.size(), sources_.colors.size()};
  const bool hasNewCounts = !std::equal(std::begin(counts), std::end(counts), counts_);
  const bool isRebuilt = hasNewNodes || hasNewTopology || hasNewCounts;
  const bool hasNewValues = sourcesChanged();
  if (isRebuilt) {
    std::copy(std::begin(counts), std::end(counts), counts_);
    rebuild(mesh);
  } else if (!hasNewValues) {
    return;
  }
  if (!usesNormals_) sources_.normals = {};
  if (!usesColors_) sources_.colors = {};
  layout_.fill(sources_, mesh);
  ++mesh.vertexRevision;
}

void CoordinateGeometryNode::readSources() {
  sources_ = {};
  if (auto* node = coord.get()) sources_.points = node->points();
  if (auto* node = normal.get()) sources_.normals = node->normals();
  if (auto* node = color.get()) sources_.colors = node->colors();
}

bool CoordinateGeometryNode::sourcesChanged() {
  bool isChanged = false;
  if (auto* node = coord.get()) isChanged |= values_[0].changed(node->source());
  if (auto* node = normal.get()) isChanged |= values_[1].changed(node->source());
  if (auto* node = color.get()) isChanged |= values_[2].changed(node->source());
  return isChanged;
}

void CoordinateGeometryNode::rebuild(RenderMesh& mesh) {
  FaceList faces;
  if (!sources_.points.empty()) collect(sources_.points.size(), faces);
  setProperties(mesh);
  const std::size_t dropped = faces.dropFacesWithoutPoints(sources_.points.size());
  if (dropped > 0) warnOnce(fmt::format("{} parts have points that coord lacks: left out", dropped));
  settleNormals(faces, mesh);
  settleColors(faces);
  layout_.assign(faces.corners, primitives(faces, sources_.points), mesh);
  ++mesh.topologyRevision;
}

void CoordinateGeometryNode::settleNormals(FaceList& faces, const RenderMesh& mesh) {
  const bool isShaded = mesh.primitive == RenderMesh::Primitive::triangles;
  usesNormals_ = isShaded && !sources_.normals.empty();
  if (usesNormals_ && !allAmong(faces, &Corner::normal, sources_.normals.size())) {
    warnOnce("corners have normals that normal lacks: all normals are computed");
    usesNormals_ = false;
  }
  if (usesNormals_) return;
  for (Corner& corner : faces.corners) corner.normal = -1;
  if (!isShaded) return;
  const auto groups = smoothingGroups(faces, sources_.points, smoothAngle());
  for (std::size_t i = 0; i < groups.size(); ++i)
    faces.corners[i].normal = static_cast<std::int32_t>(groups[i]);
}

void CoordinateGeometryNode::settleColors(FaceList& faces) {
  usesColors_ = !sources_.colors.empty();
  if (usesColors_ && !allAmong(faces, &Corner::color, sources_.colors.size())) {
    warnOnce("corners have colours that color lacks: drawn without colours");
    usesColors_ = false;
  }
  if (usesColors_) return;
  for (Corner& corner : faces.corners) corner.color = -1;
}

void CoordinateGeometryNode::warnOnce(const std::string& message) {
  if (isInitialized() && !hasWarned_) context().warn(*this, message);
  hasWarned_ = true;
}

}  // namespace pleura
