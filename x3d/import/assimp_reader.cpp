#include <stdexcept>
#include <utility>

#include <Eigen/LU>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <pleura/x3d/import/assimp_reader.h>

namespace pleura {

namespace {

using Eigen::Matrix4d;

constexpr std::size_t mostTriangles = 50'000'000;  // a small file can ask for any number of copies

Matrix4d toEigen(const aiMatrix4x4& m) {
  Matrix4d result;
  for (unsigned int row = 0; row < 4; ++row)
    for (unsigned int column = 0; column < 4; ++column) result(row, column) = m[row][column];
  return result;
}

Eigen::Vector4f colourOf(const aiMaterial& material) {
  Eigen::Vector4f colour(0.8f, 0.8f, 0.8f, 1);
  if (aiColor4D found; material.Get(AI_MATKEY_BASE_COLOR, found) == AI_SUCCESS ||
                       material.Get(AI_MATKEY_COLOR_DIFFUSE, found) == AI_SUCCESS)
    colour = {found.r, found.g, found.b, found.a};
  if (float opacity = 1; material.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS) colour[3] = opacity;
  return colour;
}

RawPart partOf(const aiMesh& mesh, const aiMaterial& material, const aiNode& node,
               const Matrix4d& transform) {
  RawPart part{mesh.mName.length > 0 ? mesh.mName.C_Str() : node.mName.C_Str(), colourOf(material), {}, {}};
  part.points.reserve(mesh.mNumVertices);
  for (unsigned int i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& point = mesh.mVertices[i];
    part.points.push_back((transform * Eigen::Vector4d(point.x, point.y, point.z, 1)).head<3>());
  }
  const bool isMirrored = transform.topLeftCorner<3, 3>().determinant() < 0;
  for (unsigned int i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines; polygons are triangles by now
    Eigen::Vector3i triangle = Eigen::Map<const Eigen::Matrix<unsigned int, 3, 1>>(face.mIndices).cast<int>();
    if (isMirrored) std::swap(triangle[1], triangle[2]);
    part.triangles.push_back(triangle);
  }
  return part;
}

std::vector<RawPart> partsOf(const aiScene& scene) {
  std::vector<RawPart> parts;
  std::size_t triangles = 0;
  std::vector<std::pair<const aiNode*, Matrix4d>>
      pending;  // not recursion: nodes may be nested as deep as one likes
  pending.emplace_back(scene.mRootNode, Matrix4d::Identity());
  while (!pending.empty()) {
    const auto [node, parent] = pending.back();
    pending.pop_back();
    const Matrix4d transform = parent * toEigen(node->mTransformation);
    for (unsigned int i = 0; i < node->mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[node->mMeshes[i]];
      triangles += mesh.mNumFaces;
      if (triangles > mostTriangles)
        throw std::runtime_error("more than " + std::to_string(mostTriangles) + " triangles");
      parts.push_back(partOf(mesh, *scene.mMaterials[mesh.mMaterialIndex], *node, transform));
    }
    for (unsigned int i = node->mNumChildren; i > 0; --i)
      pending.emplace_back(node->mChildren[i - 1], transform);
  }
  return parts;
}

}  // namespace

std::vector<RawPart> readWithAssimp(const std::filesystem::path& file, std::unique_ptr<GuardedFiles> files) {
  Assimp::Importer importer;
  importer.SetIOHandler(files.release());  // the importer's own from now on
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_ValidateDataStructure | aiProcess_Triangulate);
  if (scene == nullptr) throw std::runtime_error(importer.GetErrorString());
  return partsOf(*scene);
}

bool isReadByAssimp(const std::filesystem::path& file) {
  return Assimp::Importer().IsExtensionSupported(file.extension().string());
}

}  // namespace pleura
