#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <system_error>

#include <Eigen/LU>

#include <pleura/nodes/deformable/mesh/mesh_report.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/deformable/mesh/weld.h>
#include <pleura/x3d/import/assimp_reader.h>
#include <pleura/x3d/import/isolated_call.h>
#include <pleura/x3d/import/mesh_import.h>
#include <pleura/x3d/import/raw_part.h>

namespace pleura {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr unsigned int readingLimit = 60;  // seconds of processor time

Matrix3d checkedFrame(const MeshImportOptions& options) {
  if (!std::isfinite(options.scale) || options.scale <= 0)
    throw std::invalid_argument("scale: must be more than 0");
  const auto isFinite = [](double x) { return std::isfinite(x); };
  if (!std::ranges::all_of(options.axes.reshaped(), isFinite) || options.axes.determinant() == 0)
    throw std::invalid_argument("axes: must be finite and span space");
  return options.axes * options.scale;
}

float toUnitInterval(float x) { return std::isfinite(x) ? std::clamp(x, 0.0f, 1.0f) : 1.0f; }

bool fitsFloat(const Vector3d& point, double largest) {
  return std::all_of(point.begin(), point.end(),
                     [largest](double x) { return std::isfinite(x) && std::abs(x) <= largest; });
}

/// Readers give each corner of a triangle its own point.
void joinEqualPoints(TriangleMesh& mesh) {
  const std::vector<int> standIn = weldedPoints(mesh.points, 0);
  for (Vector3i& triangle : mesh.triangles)
    for (int& corner : triangle) corner = standIn[corner];
  removeUnreferencedPoints(mesh);
}

TriangleMesh checkedMesh(const RawPart& raw, const Matrix3d& frame) {
  constexpr double largest = std::numeric_limits<float>::max();
  TriangleMesh mesh{{}, raw.triangles};
  for (const Vector3d& point : raw.points) {
    // checked before it is moved too, for infinity times 0 is what we're here to prevent
    const Vector3d moved = fitsFloat(point, largest) ? Vector3d(frame * point) : point;
    if (!fitsFloat(moved, largest))
      throw std::invalid_argument("a coordinate is not finite, or beyond a float's range");
    mesh.points.push_back(moved.cast<float>());
  }
  requireIndicesInRange(mesh.points.size(), mesh.triangles);
  if (frame.determinant() < 0)
    for (Vector3i& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  joinEqualPoints(mesh);
  return mesh;
}

ImportedScene importFrom(std::unique_ptr<GuardedFiles> files, const std::filesystem::path& file,
                         const MeshImportOptions& options) {
  const Matrix3d frame = checkedFrame(options);
  const std::string extension = file.extension().string();
  if (extension.empty()) throw MeshImportError(file, "no extension to tell the format by");
  if (!isReadByAssimp(file)) throw MeshImportError(file, "no reader for " + extension);
  ImportedScene scene;
  try {
    const std::string bytes =
        isolatedCall([&] { return pack(readWithAssimp(file, std::move(files))); }, readingLimit);
    for (const RawPart& raw : unpack(bytes)) {
      if (raw.triangles.empty()) continue;
      scene.parts.push_back({raw.name.empty() ? file.stem().string() : raw.name, checkedMesh(raw, frame),
                             raw.colour.unaryExpr(&toUnitInterval)});
    }
  } catch (const std::exception& error) {
    throw MeshImportError(file, error.what());
  }
  if (scene.parts.empty()) throw MeshImportError(file, "no triangles");
  for (const ImportedPart& part : scene.parts)
    for (const std::string& fault : faults(analyze(part.mesh)))
      scene.diagnostics.push_back(part.name + ": " + fault);
  return scene;
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
