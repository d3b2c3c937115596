#include <algorithm>
#include <cfenv>
#include <cmath>
#include <memory>
#include <sstream>
#include <system_error>

#include <Eigen/LU>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <pleura/x3d/import/assimp_scene.h>
#include <pleura/x3d/import/guarded_files.h>
#include <pleura/x3d/import/mesh_import.h>

namespace pleura {

namespace {

using Eigen::Matrix3d;

/// Whoever traps floating-point exceptions, as our tests do, doesn't mean those inside assimp.
class UntrappedFloatingPoint {
 public:
  UntrappedFloatingPoint() { std::feholdexcept(&saved_); }
  ~UntrappedFloatingPoint() { std::fesetenv(&saved_); }
  UntrappedFloatingPoint(const UntrappedFloatingPoint&) = delete;
  UntrappedFloatingPoint& operator=(const UntrappedFloatingPoint&) = delete;

 private:
  std::fenv_t saved_;
};

Matrix3d checkedFrame(const MeshImportOptions& options) {
  if (!std::isfinite(options.scale) || options.scale <= 0)
    throw std::invalid_argument("scale: must be more than 0");
  const auto isFinite = [](double x) { return std::isfinite(x); };
  if (!std::ranges::all_of(options.axes.reshaped(), isFinite) || options.axes.determinant() == 0)
    throw std::invalid_argument("axes: must be finite and span space");
  return options.axes * options.scale;
}

void requireReader(const Assimp::Importer& importer, const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension.empty()) throw MeshImportError(file, "no extension to tell the format by");
  if (!importer.IsExtensionSupported(extension)) throw MeshImportError(file, "no reader for " + extension);
}

/// Assimp's triangulation ends the program on a mesh that claims polygons and has none.
void requireTruePolygons(const aiScene& scene, const std::filesystem::path& file) {
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    const auto isPolygon = [](const aiFace& face) { return face.mNumIndices > 3; };
    const bool claimsPolygons = (mesh->mPrimitiveTypes & aiPrimitiveType_POLYGON) != 0;
    if (claimsPolygons && std::none_of(mesh->mFaces, mesh->mFaces + mesh->mNumFaces, isPolygon))
      throw MeshImportError(file, "its faces don't have the corners they should");
  }
}

ImportedScene importFrom(std::unique_ptr<GuardedFiles> files, const std::filesystem::path& file,
                         const MeshImportOptions& options) {
  const Matrix3d frame = checkedFrame(options);
  Assimp::Importer importer;
  requireReader(importer, file);
  importer.SetIOHandler(files.release());  // the importer's own from now on
  ImportedScene result;
  try {
    const UntrappedFloatingPoint untrapped;
    const aiScene* scene = importer.ReadFile(file.string(), aiProcess_ValidateDataStructure);
    if (scene != nullptr) requireTruePolygons(*scene, file);
    if (scene != nullptr) scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
    if (scene == nullptr) throw MeshImportError(file, importer.GetErrorString());
    result = partsOf(*scene, file, frame);
  } catch (const MeshImportError&) {
    throw;
  } catch (const std::exception& error) {
    throw MeshImportError(file, error.what());
  }
  if (result.parts.empty()) throw MeshImportError(file, "no triangles");
  return result;
}

}  // namespace

Matrix3d axesNamed(const std::string& text) {
  std::string blanks = text;
  std::ranges::replace(blanks, ',', ' ');
  std::istringstream words(blanks);
  Matrix3d axes = Matrix3d::Zero();
  const std::string names = "xyz";
  int row = 0;
  for (std::string word; words >> word; ++row) {
    const bool isNegative = word[0] == '-';
    const std::size_t column = word.size() == (isNegative ? 2u : 1u) ? names.find(word.back()) : names.npos;
    if (row > 2 || column == names.npos)
      throw std::invalid_argument("axes: \"" + text + "\" is not like \"x z -y\"");
    axes(row, static_cast<int>(column)) = isNegative ? -1 : 1;
  }
  if (axes.determinant() == 0)
    throw std::invalid_argument("axes: \"" + text + "\" doesn't name x, y and z once each");
  return axes;
}

ImportedScene importMesh(const std::filesystem::path& file, const MeshImportOptions& options) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw MeshImportError(file, "no such file");
  if (!std::filesystem::is_regular_file(status)) throw MeshImportError(file, "not a file");
  if (std::filesystem::file_size(file, error) == 0 || error)
    throw MeshImportError(file, "empty, or can't be read");
  return importFrom(std::make_unique<GuardedFiles>(), file, options);
}

ImportedScene importMesh(std::span<const std::byte> content, const std::string& name,
                         const MeshImportOptions& options) {
  const std::filesystem::path file(name);
  if (content.empty()) throw MeshImportError(file, "empty");
  return importFrom(std::make_unique<GuardedFiles>(name, content), file, options);
}

}  // namespace pleura
