#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "mesh_checks.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/anatomy/measurements.h>

namespace pleura {
namespace {

using Eigen::Vector3f;

double measuredFigure(std::string_view quantity) {
  const Table cage = measurementTable("cage");
  for (std::size_t row = 0; row < cage.rows(); ++row) {
    if (cage.text(row, "quantity") == quantity) return cage.number(row, "value");
  }
  throw std::out_of_range("no such figure");
}

SurfaceQuery queryOf(const TriangleMesh& mesh) { return SurfaceQuery(mesh.points, mesh.triangles); }

double nearestSignedDistance(const TriangleMesh& solid, const std::vector<Vector3f>& points) {
  const SurfaceQuery query = queryOf(solid);
  double nearest = 1.0;
  for (const Vector3f& point : points)
    nearest = std::min(nearest, query.signedDistance(point.cast<double>()));
  return nearest;
}

class GeneratedAnatomy : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { anatomy = generateAnatomy(); }
  static void TearDownTestSuite() { anatomy.reset(); }
  static const Lung& lung(Side side) { return anatomy->lungs[side == Side::Left ? 0 : 1]; }

  static std::optional<Anatomy> anatomy;
};
std::optional<Anatomy> GeneratedAnatomy::anatomy;

TEST_F(GeneratedAnatomy, HasEveryPart) {
  EXPECT_EQ(anatomy->ribs.size(), 24u);
  EXPECT_EQ(anatomy->cartilages.size(), 20u);
  EXPECT_EQ(anatomy->vertebrae.size(), 12u);
  ASSERT_EQ(anatomy->lungs.size(), 2u);
  EXPECT_EQ(anatomy->lungs[0].name, "LUNG_L");
  EXPECT_EQ(anatomy->lungs[1].side, Side::Right);
  EXPECT_GE(anatomy->lungs[0].mesh.points.size(), 3000u);
  EXPECT_GE(anatomy->lungs[1].mesh.points.size(), 3000u);
  EXPECT_GE(anatomy->diaphragm.mesh.points.size(), 1500u);
}

TEST_F(GeneratedAnatomy, SolidsAreClosedAndFaceOutwards) {
  const auto expectSolid = [](const TriangleMesh& mesh, const std::string& name) {
    EXPECT_EQ(openOrTwistedEdges(mesh), 0) << name;
    EXPECT_GT(enclosedVolume(mesh), 0.0) << name;
  };
  for (const Rib& rib : anatomy->ribs) expectSolid(rib.mesh, rib.name);
  for (const Cartilage& cartilage : anatomy->cartilages) expectSolid(cartilage.mesh, cartilage.name);
  for (const Vertebra& vertebra : anatomy->vertebrae) {
    expectSolid(vertebra.bone, vertebra.name);
    expectSolid(vertebra.disc, vertebra.name + " disc");
  }
  for (const Lung& organ : anatomy->lungs) expectSolid(organ.mesh, organ.name);
  expectSolid(anatomy->sternum.mesh, "sternum");
}

TEST_F(GeneratedAnatomy, CageIsAsWideAndHighAsMeasured) {
  Eigen::AlignedBox3f box;
  for (const Rib& rib : anatomy->ribs) box.extend(boundingBox(rib.mesh.points));
  EXPECT_NEAR(box.sizes().x(), 1e-3 * measuredFigure("ribs_width"), 0.004);
  EXPECT_NEAR(box.sizes().y(), 1e-3 * measuredFigure("ribs_height"), 0.004);
  EXPECT_NEAR(box.sizes().z(), 1e-3 * measuredFigure("ribs_depth"), 0.004);
}

TEST_F(GeneratedAnatomy, LungVolumesAreNearTheMeasured) {
  EXPECT_NEAR(1e3 * enclosedVolume(lung(Side::Left).mesh), measuredFigure("left_lung_volume"), 0.1);
  EXPECT_NEAR(1e3 * enclosedVolume(lung(Side::Right).mesh), measuredFigure("right_lung_volume"), 0.1);
}

TEST_F(GeneratedAnatomy, LungsAreNeverInsideBone) {
  constexpr double kTolerance = -0.0005;
  for (const Lung& organ : anatomy->lungs) {
    for (const Rib& rib : anatomy->ribs) {
      EXPECT_GT(nearestSignedDistance(rib.mesh, organ.mesh.points), kTolerance)
          << organ.name << ' ' << rib.name;
      EXPECT_GT(nearestSignedDistance(organ.mesh, rib.mesh.points), kTolerance)
          << organ.name << ' ' << rib.name;
    }
    for (const Vertebra& vertebra : anatomy->vertebrae) {
      EXPECT_GT(nearestSignedDistance(vertebra.bone, organ.mesh.points), kTolerance) << vertebra.name;
    }
    EXPECT_GT(nearestSignedDistance(anatomy->sternum.mesh, organ.mesh.points), kTolerance);
  }
}

TEST_F(GeneratedAnatomy, LungsLieAboveTheDiaphragm) {
  const SurfaceQuery diaphragm = queryOf(anatomy->diaphragm.mesh);
  for (const Lung& organ : anatomy->lungs) {
    for (const Vector3f& point : organ.mesh.points) {
      EXPECT_GT(diaphragm.closestPoint(point.cast<double>()).distance, 0.001) << organ.name;
    }
    EXPECT_GE(nearestSignedDistance(organ.mesh, anatomy->diaphragm.mesh.points), 0.001) << organ.name;
  }
}

TEST_F(GeneratedAnatomy, LungsFillTheCageWithASmallEvenGap) {
  for (const Side side : {Side::Left, Side::Right}) {
    const SurfaceQuery skin = queryOf(lung(side).mesh);
    std::vector<double> gaps;
    for (int number = 2; number <= 6; ++number) {
      const auto& line = rib(*anatomy, side, number).innerLine;
      for (std::size_t k = 4; k + 10 < line.size(); ++k)
        gaps.push_back(skin.signedDistance(line[k].cast<double>()));
    }
    std::sort(gaps.begin(), gaps.end());
    EXPECT_GT(gaps.front(), 0.001);
    EXPECT_LT(gaps[gaps.size() / 2], 0.003);
    EXPECT_LT(gaps[gaps.size() * 9 / 10], 0.005);
  }
}

TEST_F(GeneratedAnatomy, LungsKeepToTheirSideAndRiseAboveTheFirstRib) {
  for (const Lung& organ : anatomy->lungs) {
    for (const Vector3f& point : organ.mesh.points)
      EXPECT_GT(sign(organ.side) * point.x(), 0.002f) << organ.name;
    EXPECT_GT(organ.apex.y(), rib(*anatomy, organ.side, 1).sternalEnd.y() + 0.02f) << organ.name;
  }
}

// A point in front of the heart, behind left rib 4's end, which the right lung's mirror image would contain.
TEST_F(GeneratedAnatomy, LeftLungHasACardiacNotch) {
  const Eigen::Vector3d beforeHeart = fromTableFrame({25.0, -160.0, 1235.0});
  const Eigen::Vector3d mirrored(-beforeHeart.x(), beforeHeart.y(), beforeHeart.z());
  EXPECT_GT(queryOf(lung(Side::Left).mesh).signedDistance(beforeHeart), 0.01);
  EXPECT_LT(queryOf(lung(Side::Right).mesh).signedDistance(mirrored), 0.0);
}

TEST_F(GeneratedAnatomy, LungsHaveThreeFacesWhereTheyBelong) {
  for (const Lung& organ : anatomy->lungs) {
    ASSERT_EQ(organ.part.size(), organ.mesh.points.size());
    std::array<Vector3f, 3> centre;
    centre.fill(Vector3f::Zero());
    std::array<int, 3> count{};
    for (std::size_t i = 0; i < organ.part.size(); ++i) {
      centre[static_cast<std::size_t>(organ.part[i])] += organ.mesh.points[i];
      ++count[static_cast<std::size_t>(organ.part[i])];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_GT(count[k], 200) << organ.name;
      centre[k] /= static_cast<float>(count[k]);
    }
    const float s = sign(organ.side);
    EXPECT_GT(s * centre[static_cast<int>(LungPart::Costal)].x(),
              s * centre[static_cast<int>(LungPart::Mediastinal)].x());
    EXPECT_LT(centre[static_cast<int>(LungPart::Diaphragmatic)].y(),
              centre[static_cast<int>(LungPart::Costal)].y());
  }
}

TEST_F(GeneratedAnatomy, OrgansHaveWellShapedTriangles) {
  const double degree = std::acos(-1.0) / 180.0;
  for (const TriangleMesh& mesh : {lung(Side::Left).mesh, lung(Side::Right).mesh, anatomy->diaphragm.mesh}) {
    std::vector<double> angles = smallestAngles(mesh);
    std::sort(angles.begin(), angles.end());
    EXPECT_GT(angles.front(), 5.0 * degree);
    EXPECT_GT(angles[angles.size() / 100], 25.0 * degree);
  }
}

TEST_F(GeneratedAnatomy, DomesAreAsHighAsMeasured) {
  const auto height = [](double zMm) { return fromTableFrame({0.0, 0.0, zMm}).y(); };
  EXPECT_NEAR(anatomy->diaphragm.domeTopLeft.y(), height(measuredFigure("diaphragm_left_dome_top_z")), 0.002);
  EXPECT_NEAR(anatomy->diaphragm.domeTopRight.y(), height(measuredFigure("diaphragm_right_dome_top_z")),
              0.002);
}

TEST_F(GeneratedAnatomy, DiaphragmIsOneSheetWithOneRim) {
  const Diaphragm& d = anatomy->diaphragm;
  ASSERT_EQ(d.part.size(), d.mesh.points.size());
  ASSERT_EQ(d.s.size(), d.mesh.points.size());
  ASSERT_EQ(d.azimuth.size(), d.mesh.points.size());
  std::vector<bool> onBorder(d.mesh.points.size(), false);
  const std::vector<EdgeUse> uses = edgeUses(d.mesh.triangles);
  std::size_t edges = 0;
  for (std::size_t i = 0, next = 0; i < uses.size(); i = next, ++edges) {
    while (next < uses.size() && uses[next].sameEdge(uses[i])) ++next;
    ASSERT_LE(next - i, 2u);
    if (next - i == 1) onBorder[uses[i].low] = onBorder[uses[i].high] = true;
  }
  for (std::size_t i = 0; i < onBorder.size(); ++i)
    EXPECT_EQ(onBorder[i], d.part[i] == DiaphragmPart::Rim) << i;
  EXPECT_EQ(static_cast<int>(d.mesh.points.size()) - static_cast<int>(edges) +
                static_cast<int>(d.mesh.triangles.size()),
            1);
}

TEST_F(GeneratedAnatomy, DiaphragmHasATendonOnTopAndAWallAtTheRibs) {
  const Diaphragm& d = anatomy->diaphragm;
  std::array<int, 4> count{};
  for (std::size_t i = 0; i < d.part.size(); ++i) {
    ++count[static_cast<std::size_t>(d.part[i])];
    if (d.part[i] == DiaphragmPart::Tendon) {
      EXPECT_GT(d.mesh.points[i].y(), -0.03f);
    }
    EXPECT_EQ(d.part[i] == DiaphragmPart::Rim, d.s[i] == 2.0f);
  }
  for (const int n : count) EXPECT_GT(n, 80);
}

TEST_F(GeneratedAnatomy, DiaphragmLiesInsideTheCage) {
  for (const Rib& rib : anatomy->ribs) {
    EXPECT_GT(nearestSignedDistance(rib.mesh, anatomy->diaphragm.mesh.points), -0.0005) << rib.name;
  }
}

TEST_F(GeneratedAnatomy, CartilagesHangTogether) {
  for (const Cartilage& c : anatomy->cartilages) {
    const TriangleMesh& bone = rib(*anatomy, c.side, c.number).mesh;
    const TriangleMesh& joined =
        c.joins == 0 ? anatomy->sternum.mesh : cartilage(*anatomy, c.side, c.joins).mesh;
    EXPECT_LT(queryOf(bone).signedDistance(c.start.cast<double>()), 0.0) << c.name;
    EXPECT_LT(queryOf(joined).signedDistance(c.end.cast<double>()), 0.001) << c.name;
  }
}

TEST_F(GeneratedAnatomy, VertebraeReachTheirMeasuredTips) {
  for (const Vertebra& v : anatomy->vertebrae) {
    const SurfaceQuery bone = queryOf(v.bone);
    for (const Vector3f& tip : {v.spinousTip, v.transverseTipLeft, v.transverseTipRight}) {
      EXPECT_LT(bone.closestPoint(tip.cast<double>()).distance, 0.002) << v.name;
    }
    EXPECT_LT(bone.signedDistance(v.bodyCentre.cast<double>()), -0.005) << v.name;
  }
}

TEST_F(GeneratedAnatomy, SternumHasItsLandmarks) {
  const SurfaceQuery bone = queryOf(anatomy->sternum.mesh);
  for (const Vector3f& at :
       {anatomy->sternum.jugularNotch, anatomy->sternum.sternalAngle, anatomy->sternum.xiphoidTip}) {
    EXPECT_LT(bone.closestPoint(at.cast<double>()).distance, 0.008);
  }
}

bool sameBytes(const TriangleMesh& a, const TriangleMesh& b) {
  return a.points.size() == b.points.size() && a.triangles.size() == b.triangles.size() &&
         std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(a.points[0])) == 0 &&
         std::memcmp(a.triangles.data(), b.triangles.data(), a.triangles.size() * sizeof(a.triangles[0])) ==
             0;
}

TEST_F(GeneratedAnatomy, IsTheSameAtEveryCall) {
  const Anatomy again = generateAnatomy();
  for (std::size_t i = 0; i < again.ribs.size(); ++i) {
    EXPECT_TRUE(sameBytes(again.ribs[i].mesh, anatomy->ribs[i].mesh)) << again.ribs[i].name;
  }
  EXPECT_TRUE(sameBytes(again.sternum.mesh, anatomy->sternum.mesh));
  EXPECT_TRUE(sameBytes(again.vertebrae[7].bone, anatomy->vertebrae[7].bone));
  EXPECT_TRUE(sameBytes(again.diaphragm.mesh, anatomy->diaphragm.mesh));
  EXPECT_TRUE(sameBytes(again.lungs[0].mesh, anatomy->lungs[0].mesh));
  EXPECT_TRUE(sameBytes(again.lungs[1].mesh, anatomy->lungs[1].mesh));
}

}  // namespace
}  // namespace pleura
