#include <cstdlib>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/mesh_report.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/x3d/import/mesh_import.h>

namespace pleura {
namespace {

/// The real meshes, by stem; none where they aren't.
std::map<std::string, std::filesystem::path> anatomy() {
  const char* shared = std::getenv("PLEURA_SHARED");
  const std::filesystem::path root =
      (shared != nullptr ? std::filesystem::path(shared)
                         : std::filesystem::path(PLEURA_SOURCE_DIR) / "../shared") /
      "anatomy";
  std::map<std::string, std::filesystem::path> found;
  if (!std::filesystem::is_directory(root)) return found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
    if (entry.path().extension() == ".obj") found[entry.path().stem().string()] = entry.path();
  return found;
}

class Anatomy : public testing::Test {
 protected:
  void SetUp() override {
    files_ = anatomy();
    if (files_.empty()) GTEST_SKIP() << "no real meshes: set PLEURA_SHARED to the folder that holds anatomy/";
  }

  TriangleMesh mesh(const std::string& stem) const {
    return importMesh(files_.at(stem), {.scale = 0.001, .axes = axesNamed("x z -y")}).parts.at(0).mesh;
  }

  std::map<std::string, std::filesystem::path> files_;
};

TEST_F(Anatomy, EveryMeshImportsAsOnePart) {
  EXPECT_EQ(files_.size(), 97u);
  for (const auto& [stem, path] : files_) {
    const ImportedScene scene = importMesh(path, {.scale = 0.001, .axes = axesNamed("x z -y")});
    EXPECT_EQ(scene.parts.size(), 1u) << stem;
    EXPECT_GT(scene.parts[0].mesh.triangles.size(), 150u) << stem;
    EXPECT_LT(analyze(scene.parts[0].mesh).box.sizes().maxCoeff(), 2.0f) << stem << " in metres";
  }
}

TEST_F(Anatomy, LungsAreClosedAndHoldWhatTheyShould) {
  const MeshReport left = analyze(mesh("left_lung")), right = analyze(mesh("right_lung"));
  EXPECT_TRUE(left.isClosed && right.isClosed);
  EXPECT_NEAR(left.volume + right.volume, 2.70e-3, 0.05e-3);
}

TEST_F(Anatomy, FaultsAreThoseOfTheData) {
  EXPECT_GT(analyze(mesh("external_intercostal_muscle")).boundaryEdges, 5000);
  EXPECT_TRUE(analyze(mesh("external_intercostal_muscle")).isSoup);
  EXPECT_TRUE(analyze(mesh("internal_intercostal_muscle")).isSoup);
  EXPECT_EQ(analyze(mesh("left_twelfth_rib")).boundaryEdges, 8);
  EXPECT_EQ(analyze(mesh("left_third_rib")).nonManifoldEdges, 1);
  EXPECT_GT(analyze(mesh("first_thoracic_vertebra")).boundaryEdges, 0);
  EXPECT_GT(analyze(mesh("left_lower_lobe")).nonManifoldEdges, 0);
}

TEST_F(Anatomy, RepairMakesEveryMeshSoundAndKeepsItsShape) {
  for (const auto& [stem, path] : files_) {
    SCOPED_TRACE(stem);
    TriangleMesh repaired = mesh(stem);
    const MeshReport before = analyze(repaired);
    repair(repaired);
    const MeshReport after = analyze(repaired);
    EXPECT_EQ(after.nonManifoldEdges, 0);
    EXPECT_EQ(after.misorientedEdges, 0);
    EXPECT_EQ(after.degenerateTriangles + after.duplicateTriangles + after.unreferencedPoints, 0);
    EXPECT_LE(after.boundaryEdges, before.boundaryEdges + 2 * before.nonManifoldEdges);
    EXPECT_LT((after.box.sizes() - before.box.sizes()).norm(), 0.05f * before.box.sizes().norm());
    EXPECT_NEAR(after.area / before.area, 1, 0.3);
  }
}

TEST_F(Anatomy, RepairClosesTheRibsAndOrgansThatBreathe) {
  int ribs = 0;
  for (const auto& [stem, path] : files_) {
    const bool isRib = stem.ends_with("_rib");
    if (!isRib && !stem.ends_with("_lung") && stem != "diaphragm") continue;
    ribs += isRib ? 1 : 0;
    TriangleMesh repaired = mesh(stem);
    repair(repaired);
    const MeshReport report = analyze(repaired);
    EXPECT_TRUE(report.isClosed) << stem;
    EXPECT_GT(report.volume, 0) << stem;
  }
  EXPECT_EQ(ribs, 24);
}

}  // namespace
}  // namespace pleura
