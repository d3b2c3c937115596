#include <array>
#include <cstdlib>
#include <numbers>
#include <optional>

#include "mesh_checks.h"
#include "obj_reader.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/thorax/anatomy/bones.h>
#include <pleura/nodes/thorax/anatomy/from_meshes.h>
#include <pleura/nodes/thorax/anatomy/scanned_organs.h>

namespace pleura {
namespace {

std::filesystem::path meshDirectory() {
  const char* shared = std::getenv("PLEURA_SHARED");
  const std::filesystem::path root =
      shared ? shared : std::filesystem::path(PLEURA_SOURCE_DIR) / ".." / "shared";
  return root / "anatomy";
}

class AnatomyFromMeshes : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (std::filesystem::is_directory(meshDirectory() / "skeleton")) {
      real = anatomyFromMeshes(meshDirectory(), readObj);
      generated = generateAnatomy();
    }
  }
  static void TearDownTestSuite() {
    real.reset();
    generated.reset();
  }
  void SetUp() override {
    if (!real) GTEST_SKIP() << "no real meshes at " << meshDirectory() << "; set PLEURA_SHARED";
  }

  static std::optional<Anatomy> real, generated;
};
std::optional<Anatomy> AnatomyFromMeshes::real, AnatomyFromMeshes::generated;

TEST_F(AnatomyFromMeshes, LandmarksAgreeWithTheMeasuredOnes) {
  for (std::size_t i = 0; i < real->ribs.size(); ++i) {
    const Rib& a = real->ribs[i];
    const Rib& b = generated->ribs[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_LT((a.head - b.head).norm(), 0.010f) << a.name;
    EXPECT_LT((a.sternalEnd - b.sternalEnd).norm(), 0.016f) << a.name;
    if (a.number <= 10) {  // ribs 11 and 12 meet no transverse process
      EXPECT_LT((a.tubercle - b.tubercle).norm(), 0.016f) << a.name;
    }
    EXPECT_LT((a.centreline[16] - b.centreline[16]).norm(), 0.012f) << a.name;
    EXPECT_GT(a.neckAxis.dot(b.neckAxis), 0.8f) << a.name;
  }
  for (std::size_t i = 0; i < real->vertebrae.size(); ++i) {
    EXPECT_LT((real->vertebrae[i].bodyCentre - generated->vertebrae[i].bodyCentre).norm(), 0.008f) << i;
    EXPECT_GT(real->vertebrae[i].up.dot(generated->vertebrae[i].up), 0.95f) << i;
  }
}

TEST_F(AnatomyFromMeshes, RibsAreClosedAndAsBigAsTheGenerated) {
  for (std::size_t i = 0; i < real->ribs.size(); ++i) {
    EXPECT_EQ(openOrTwistedEdges(real->ribs[i].mesh), 0) << real->ribs[i].name;
    const double ratio = enclosedVolume(real->ribs[i].mesh) / enclosedVolume(generated->ribs[i].mesh);
    EXPECT_GT(ratio, 0.8) << real->ribs[i].name;
    EXPECT_LT(ratio, 1.25) << real->ribs[i].name;
  }
}

TEST_F(AnatomyFromMeshes, LungsLieInsideTheCageAndAboveTheDiaphragm) {
  for (const Lung& lung : real->lungs) {
    EXPECT_EQ(lung.part.size(), lung.mesh.points.size());
    EXPECT_NEAR(1e3 * enclosedVolume(lung.mesh), lung.side == Side::Left ? 1.22 : 1.47, 0.12) << lung.name;
    for (const Rib& rib : real->ribs) {
      const SurfaceQuery bone(rib.mesh.points, rib.mesh.triangles);
      for (const auto& point : lung.mesh.points) {
        EXPECT_GT(bone.signedDistance(point.cast<double>()), -0.0005) << lung.name << ' ' << rib.name;
      }
    }
  }
}

TEST_F(AnatomyFromMeshes, OrgansHaveAllTheirParts) {
  std::array<int, 4> diaphragm{};
  for (const DiaphragmPart part : real->diaphragm.part) ++diaphragm[static_cast<std::size_t>(part)];
  for (const int n : diaphragm) EXPECT_GT(n, 20);
  EXPECT_NEAR(real->diaphragm.domeTopRight.y(), generated->diaphragm.domeTopRight.y(), 0.005);
  for (const Lung& lung : real->lungs) {
    std::array<int, 3> faces{};
    for (const LungPart part : lung.part) ++faces[static_cast<std::size_t>(part)];
    for (const int n : faces) EXPECT_GT(n, 50) << lung.name;
  }
}

TEST_F(AnatomyFromMeshes, OfASlabTheFaceTowardsTheLungsIsTaken) {
  const TriangleMesh& sheet = real->diaphragm.mesh;
  const TriangleMesh scan = readObj(meshDirectory() / "organs" / "diaphragm.obj");
  EXPECT_NEAR(1e6 * surfaceArea(sheet.points, sheet.triangles),
              0.52 * surfaceArea(scan.points, scan.triangles), 6000);  // [mm^2] of a slab of 235,000
  EXPECT_GT(openOrTwistedEdges(sheet), 0);
}

/// A dome over a ring: a quarter of a sphere down to the wall, so that parts can be told.
class ScannedDome : public ::testing::Test {
 protected:
  inline static const Eigen::Vector3f kMiddle{0.0f, -0.05f, 0.045f};  // clear of bones

  static TriangleMesh dome(float radius, bool facesOut) {
    constexpr int kAround = 48;
    constexpr int kDown = 16;
    TriangleMesh mesh;
    for (int i = 0; i < kAround; ++i) {
      for (int j = 0; j <= kDown; ++j) {
        const float a = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kAround;
        const float b = 0.1f + 1.6f * static_cast<float>(j) / kDown;
        mesh.points.emplace_back(radius * std::sin(b) * std::cos(a), radius * std::cos(b) + kMiddle.y(),
                                 radius * std::sin(b) * std::sin(a) + kMiddle.z());
      }
    }
    for (int i = 0; i < kAround; ++i) {
      for (int j = 0; j < kDown; ++j) {
        const auto at = [&](int u, int v) { return u % kAround * (kDown + 1) + v; };
        const std::array<Eigen::Vector3i, 2> quad{
            Eigen::Vector3i(at(i, j), at(i + 1, j), at(i, j + 1)),
            Eigen::Vector3i(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))};
        for (const Eigen::Vector3i& t : quad)
          mesh.triangles.push_back(facesOut ? t : Eigen::Vector3i(t[0], t[2], t[1]));
      }
    }
    return mesh;
  }

  static Diaphragm scanned(const TriangleMesh& mesh) {
    static const Anatomy cage = generateAnatomy();
    const std::array<ChestWall, 2> walls{ChestWall(cage.ribs, cage.cartilages, Side::Left, 0.0),
                                         ChestWall(cage.ribs, cage.cartilages, Side::Right, 0.0)};
    return scannedDiaphragm(mesh, walls, bonesOf(cage));
  }
};

TEST_F(ScannedDome, SheetSlabAndASheetFacingInwardsGiveTheSame) {
  const TriangleMesh upper = dome(0.035f, true);
  const TriangleMesh lower = dome(0.031f, false);
  const TriangleMesh expected = scanned(upper).mesh;
  EXPECT_GT(expected.triangles.size(), upper.triangles.size());  // refined
  for (const TriangleMesh& scan : {dome(0.035f, false), merged({&upper, &lower})}) {
    const TriangleMesh got = scanned(scan).mesh;
    ASSERT_EQ(got.points.size(), expected.points.size());
    EXPECT_NEAR(surfaceArea(got.points, got.triangles), surfaceArea(expected.points, expected.triangles),
                1e-7);
    std::vector<Eigen::Vector3f> normals(got.points.size());
    vertexNormals(got.points, got.triangles, normals);
    for (std::size_t i = 0; i < normals.size(); ++i) EXPECT_GT(normals[i].dot(got.points[i] - kMiddle), 0.0f);
  }
}

TEST(AnatomyFromMeshesErrors, AFolderWithoutASkeletonIsRefused) {
  EXPECT_THROW(anatomyFromMeshes(std::filesystem::path(PLEURA_SOURCE_DIR) / "nodes", readObj),
               std::invalid_argument);
}

}  // namespace
}  // namespace pleura
