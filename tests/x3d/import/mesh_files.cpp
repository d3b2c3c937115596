#include "mesh_files.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "../../nodes/deformable/mesh/shapes.h"
#include <assimp/Exporter.hpp>
#include <assimp/scene.h>
#include <unistd.h>

namespace pleura::files {

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "pleura_import_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("can't make " + name);
  path_ = name;
}

Folder::~Folder() { std::filesystem::remove_all(path_); }

std::filesystem::path Folder::write(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return path_ / name;
}

TriangleMesh cube() { return shapes::cube(); }

TriangleMesh bumpySphere() {
  TriangleMesh mesh = shapes::sphere(17);
  for (Eigen::Vector3f& p : mesh.points) p *= 1 + 0.1f * std::sin(5 * p.x()) * std::cos(4 * p.y() + p.z());
  return mesh;
}

std::string read(const std::filesystem::path& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

std::string asObj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(9);
  for (const Eigen::Vector3f& p : mesh.points) text << "v " << p.transpose() << '\n';
  for (const Eigen::Vector3i& t : mesh.triangles) text << "f " << (t.array() + 1).transpose() << '\n';
  return text.str();
}

std::filesystem::path exported(const TriangleMesh& mesh, const std::string& format, const Folder& folder) {
  return exportedAt(mesh, Eigen::Vector3f::Zero(), format, folder);
}

std::filesystem::path exportedAt(const TriangleMesh& mesh, const Eigen::Vector3f& place,
                                 const std::string& format, const Folder& folder) {
  auto* target = new aiMesh;
  target->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  target->mNumVertices = static_cast<unsigned int>(mesh.points.size());
  target->mVertices = new aiVector3D[mesh.points.size()];
  target->mNormals = new aiVector3D[mesh.points.size()];
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    target->mVertices[i] = aiVector3D(mesh.points[i].x(), mesh.points[i].y(), mesh.points[i].z());
    target->mNormals[i] = aiVector3D(0, 0, 1);
  }
  target->mNumFaces = static_cast<unsigned int>(mesh.triangles.size());
  target->mFaces = new aiFace[mesh.triangles.size()];
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    target->mFaces[t].mNumIndices = 3;
    target->mFaces[t].mIndices = new unsigned int[3];
    for (int k = 0; k < 3; ++k)
      target->mFaces[t].mIndices[k] = static_cast<unsigned int>(mesh.triangles[t][k]);
  }
  aiScene scene;  // owns all of it
  scene.mNumMeshes = 1;
  scene.mMeshes = new aiMesh* [1] { target };
  scene.mNumMaterials = 1;
  scene.mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene.mRootNode = new aiNode("part");
  scene.mRootNode->mNumMeshes = 1;
  scene.mRootNode->mMeshes = new unsigned int[1]{0};
  aiMatrix4x4::Translation(aiVector3D(place.x(), place.y(), place.z()), scene.mRootNode->mTransformation);
  Assimp::Exporter exporter;
  for (std::size_t i = 0; i < exporter.GetExportFormatCount(); ++i) {
    const aiExportFormatDesc* known = exporter.GetExportFormatDescription(i);
    if (format != known->id) continue;
    auto path = folder.path() / (format + "." + known->fileExtension);
    if (exporter.Export(&scene, format, path.string()) == AI_SUCCESS) return path;
  }
  throw std::runtime_error(format + ": " + exporter.GetErrorString());
}

}  // namespace pleura::files
