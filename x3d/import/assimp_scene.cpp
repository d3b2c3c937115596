#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/LU>

#include <pleura/nodes/deformable/mesh/mesh_report.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/nodes/deformable/mesh/weld.h>
#include <pleura/x3d/import/assimp_scene.h>

namespace pleura {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;

constexpr std::size_t mostTriangles = 50'000'000;  // a small file can ask for any number of copies

Matrix4d toEigen(const aiMatrix4x4& m) {
  Matrix4d result;
  for (unsigned int row = 0; row < 4; ++row)
    for (unsigned int column = 0; column < 4; ++column) result(row, column) = m[row][column];
  return result;
}

float toUnitInterval(float x) { return std::isfinite(x) ? std::clamp(x, 0.0f, 1.0f) : 1.0f; }

Eigen::Vector4f colourOf(const aiMaterial& material) {
  Eigen::Vector4f colour = ImportedPart().colour;
  if (aiColor4D found; material.Get(AI_MATKEY_BASE_COLOR, found) == AI_SUCCESS ||
                       material.Get(AI_MATKEY_COLOR_DIFFUSE, found) == AI_SUCCESS)
    colour = {found.r, found.g, found.b, found.a};
  if (float opacity = 1; material.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS) colour[3] = opacity;
  return colour.unaryExpr(&toUnitInterval);
}

class SceneReader {
 public:
  SceneReader(const aiScene& scene, const std::filesystem::path& file) : scene_(scene), file_(file) {}

  void readNode(const aiNode& node, const Matrix4d& transform) {
    for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes)
        fail("node " + nameOf(node.mName) + " uses a mesh that isn't there");
      readMesh(*scene_.mMeshes[node.mMeshes[i]], node, transform);
    }
  }

  ImportedScene take() { return std::move(result_); }

 private:
  [[noreturn]] void fail(const std::string& why) const { throw MeshImportError(file_, why); }

  static std::string nameOf(const aiString& text) { return {text.C_Str()}; }

  void readMesh(const aiMesh& source, const aiNode& node, const Matrix4d& transform) {
    ImportedPart part;
    for (const std::string& name : {nameOf(source.mName), nameOf(node.mName), file_.stem().string()})
      if (part.name.empty()) part.name = name;
    for (unsigned int i = 0; i < source.mNumVertices; ++i)
      part.mesh.points.push_back(place(source.mVertices[i], transform, part.name));
    readTriangles(source, part, transform.determinant() < 0);
    if (part.mesh.triangles.empty()) return;
    if (source.mMaterialIndex < scene_.mNumMaterials)
      part.colour = colourOf(*scene_.mMaterials[source.mMaterialIndex]);
    joinEqualPoints(part.mesh);
    for (const std::string& fault : faults(analyze(part.mesh)))
      result_.diagnostics.push_back(part.name + ": " + fault);
    result_.parts.push_back(std::move(part));
  }

  Vector3f place(const aiVector3D& point, const Matrix4d& transform, const std::string& part) const {
    const auto fits = [](double x) {
      return std::isfinite(x) && std::abs(x) <= std::numeric_limits<float>::max();
    };
    const Vector3d moved = (transform * Eigen::Vector4d(point.x, point.y, point.z, 1)).head<3>();
    if (!std::all_of(moved.begin(), moved.end(), fits))
      fail("a coordinate of " + part + " is not finite, or beyond a float's range");
    return moved.cast<float>();
  }

  void readTriangles(const aiMesh& source, ImportedPart& part, bool isMirrored) {
    triangleCount_ += source.mNumFaces;
    if (triangleCount_ > mostTriangles) fail("more than " + std::to_string(mostTriangles) + " triangles");
    for (unsigned int i = 0; i < source.mNumFaces; ++i) {
      const aiFace& face = source.mFaces[i];
      if (face.mNumIndices != 3) continue;  // points and lines; polygons are triangles by now
      const auto inRange = [&source](unsigned int index) { return index < source.mNumVertices; };
      if (!std::all_of(face.mIndices, face.mIndices + 3, inRange))
        fail("triangle " + std::to_string(i) + " of " + part.name + " uses a point that isn't there");
      Vector3i triangle(static_cast<int>(face.mIndices[0]), static_cast<int>(face.mIndices[1]),
                        static_cast<int>(face.mIndices[2]));
      if (isMirrored) std::swap(triangle[1], triangle[2]);
      part.mesh.triangles.push_back(triangle);
    }
  }

  /// Assimp gives each corner of a triangle its own point.
  static void joinEqualPoints(TriangleMesh& mesh) {
    const std::vector<int> standIn = weldedPoints(mesh.points, 0);
    for (Vector3i& triangle : mesh.triangles)
      for (int& corner : triangle) corner = standIn[corner];
    removeUnreferencedPoints(mesh);
  }

  const aiScene& scene_;
  const std::filesystem::path& file_;
  std::size_t triangleCount_ = 0;
  ImportedScene result_;
};

}  // namespace

ImportedScene partsOf(const aiScene& scene, const std::filesystem::path& file, const Eigen::Matrix3d& frame) {
  Matrix4d toFrame = Matrix4d::Identity();
  toFrame.topLeftCorner<3, 3>() = frame;
  SceneReader reader(scene, file);
  std::vector<std::pair<const aiNode*, Matrix4d>>
      pending;  // not recursion: a file may nest nodes as deep as it likes
  if (scene.mRootNode != nullptr) pending.emplace_back(scene.mRootNode, toFrame);
  while (!pending.empty()) {
    const auto [node, parent] = pending.back();
    pending.pop_back();
    const Matrix4d transform = parent * toEigen(node->mTransformation);
    reader.readNode(*node, transform);
    for (unsigned int i = node->mNumChildren; i > 0; --i)
      pending.emplace_back(node->mChildren[i - 1], transform);
  }
  return reader.take();
}

}  // namespace pleura
