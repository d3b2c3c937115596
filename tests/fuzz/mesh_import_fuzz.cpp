#include <array>
#include <cstdint>
#include <cstdlib>

#include <pleura/nodes/deformable/mesh/mesh_report.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/x3d/import/mesh_import.h>

// The first byte chooses the format, the rest is the file. What comes back must be as importMesh and repair
// promise.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pleura;
  static constexpr std::array names = {"a.obj", "a.stl", "a.ply"};
  if (size < 2) return 0;
  try {
    const auto content = std::as_bytes(std::span(data, size)).subspan(1);
    for (ImportedPart& part : importMesh(content, names[data[0] % names.size()]).parts) {
      const MeshReport before = analyze(part.mesh);
      if (before.nonFinitePoints + before.outOfRangeTriangles + before.duplicatePoints > 0) std::abort();
      repair(part.mesh);
      const MeshReport after = analyze(part.mesh);
      if (after.nonManifoldEdges + after.misorientedEdges + after.degenerateTriangles > 0) std::abort();
    }
  } catch (const MeshImportError&) {
  }
  return 0;
}
