#include <cmath>
#include <cstring>
#include <numbers>

#include "organ.h"
#include <gtest/gtest.h>

namespace pleura {
namespace {

constexpr float kRadius = 0.1f;  // [m]

void expectFinite(const Points& points, float within) {
  for (const Eigen::Vector3f& p : points) {
    EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
    EXPECT_LE(p.cwiseAbs().maxCoeff(), within);
  }
}

std::vector<int> allPoints(const Organ& organ) {
  std::vector<int> all(organ.mesh.points.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  return all;
}

// Drives all but the first point of a ball, somewhere, and lets it recover.
void expectRecovery(const Points& targets) {
  Organ organ(icosphere(3, kRadius));
  std::vector<int> driven = allPoints(organ);
  driven.erase(driven.begin());
  organ.pull(driven, {targets.begin() + 1, targets.end()});
  expectFinite(organ.positions, 2);
  for (const int i : driven) EXPECT_EQ(organ.positions[i], targets[i]);
  EXPECT_EQ(organ.pull({}, {}).movedPoints, 0);
  EXPECT_EQ(organ.positions, organ.mesh.points);
}

TEST(ChainmailExtremes, ScrambledAndCollapsedTargets) {
  const Points ball = icosphere(3, kRadius).points;
  std::mt19937 random(1);
  Points scrambled = ball;
  std::shuffle(scrambled.begin(), scrambled.end(), random);
  expectRecovery(scrambled);
  const std::vector<Eigen::Vector3f> collapses{{1, 1, 0}, {1, 0, 0}, {0, 0, 0}, {-1, 1, 1}, {10, 10, 10}};
  for (const Eigen::Vector3f& scale : collapses) {
    Points targets;
    for (const Eigen::Vector3f& p : ball) targets.push_back(p.cwiseProduct(scale));
    expectRecovery(targets);
  }
}

TEST(ChainmailExtremes, FullTwist) {
  Points targets;
  for (const Eigen::Vector3f& p : icosphere(3, kRadius).points)
    targets.push_back(Eigen::AngleAxisf(10 * std::numbers::pi_v<float> * p.y(), Eigen::Vector3f::UnitY()) *
                      p);
  expectRecovery(targets);
}

TEST(ChainmailExtremes, RestShapesThatAreScrambledFlatOrNothing) {
  std::mt19937 random(2);
  for (const Eigen::Vector3f& scale : {Eigen::Vector3f(1, 1, 1), {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}) {
    TriangleMesh mesh = icosphere(3, kRadius);
    std::shuffle(mesh.points.begin(), mesh.points.end(), random);
    for (Eigen::Vector3f& p : mesh.points) p = p.cwiseProduct(scale);
    Organ organ(mesh);
    EXPECT_EQ(organ.pull({0}, organ.displaced({0}, {{0.3f, 0.2f, -0.1f}})).violatedLinks, 0);
    EXPECT_EQ(violations(organ, organ.positions, 1e-6).count, 0);
    organ.pull({0, 9, 77}, organ.displaced({0, 9, 77}, {{1, 0, 0}, {0, 1, 0}, {-1, 0, 1}}));
    expectFinite(organ.positions, 2);
  }
}

TEST(ChainmailExtremes, AShapeOfNoSizeMovesAsOne) {
  TriangleMesh mesh = icosphere(2, kRadius);
  for (Eigen::Vector3f& p : mesh.points) p.setConstant(0.5f);
  Organ organ(mesh);
  organ.pull({5}, {{0.25f, 0.75f, 1}});
  for (const Eigen::Vector3f& p : organ.positions) EXPECT_EQ(p, Eigen::Vector3f(0.25f, 0.75f, 1));
}

TEST(ChainmailExtremes, TenfoldStretchOfOnePointPullsAllWithinLimits) {
  Organ organ(icosphere(4, kRadius));
  const Points targets{10 * organ.mesh.points[5]};
  const ChainmailReport report = organ.pull({5}, targets);
  EXPECT_EQ(report.violatedLinks, 0);
  EXPECT_EQ(violations(organ, organ.positions, 1e-6).count, 0);
  EXPECT_EQ(organ.positions[5], targets[0]);
  EXPECT_GT(report.movedPoints, 2500);
}

// Halves of a sheet whose seam has each point twice, a sliver, and points that nothing uses.
TEST(ChainmailExtremes, BrokenMeshes) {
  TriangleMesh mesh;
  for (const int side : {0, 1})
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 4; ++row)
        mesh.points.emplace_back(0.01f * float(column + 2 * side), 0.01f * float(row), 0.0f);
  for (const int side : {0, 1})
    for (int column = 0; column < 2; ++column)
      for (int row = 0; row < 3; ++row) {
        const int a = 12 * side + 4 * column + row;
        mesh.triangles.insert(mesh.triangles.end(), {{a, a + 4, a + 5}, {a, a + 5, a + 1}});
      }
  mesh.points.emplace_back(9.0f, 9.0f, 9.0f);
  mesh.triangles.insert(mesh.triangles.end(), {{0, 0, 0}, {1, 2, 3}, {4, 4, 5}});
  Organ organ(mesh);
  EXPECT_EQ(organ.pull({0}, organ.displaced({0}, {{0, 0, 0.1f}})).violatedLinks, 0);
  for (int row = 0; row < 4; ++row)
    EXPECT_EQ(organ.positions[8 + row], organ.positions[12 + row]) << "the seam opened";
  EXPECT_GT(organ.positions[23].z(), 0.05f) << "the pull did not cross the seam";
  EXPECT_EQ(organ.positions[24], mesh.points[24]);
  organ.pull({24}, {{1, 1, 1}});
  EXPECT_EQ(organ.positions[24], Eigen::Vector3f(1, 1, 1));
  EXPECT_EQ(organ.positions[0], mesh.points[0]);
}

TEST(ChainmailExtremes, NoneOrAllDriven) {
  Organ organ(icosphere(2, kRadius));
  EXPECT_EQ(organ.pull({}, {}).movedPoints, 0);
  EXPECT_EQ(organ.positions, organ.mesh.points);
  std::mt19937 random(4);
  Points targets(organ.mesh.points.size());
  for (Eigen::Vector3f& p : targets) p = randomVector(random, 1);
  ChainmailOptions options;
  options.smoothingSweeps = 2;
  organ.pull(allPoints(organ), targets, options);
  EXPECT_EQ(organ.positions, targets);
  Organ nothing((TriangleMesh()));
  EXPECT_EQ(nothing.pull({}, {}).movedPoints, 0);
}

TEST(ChainmailExtremes, AllRigidIsATranslation) {
  Organ organ(icosphere(4, kRadius), {kRigid});
  const Eigen::Vector3f by(0.5f, -0.25f, 0.125f);
  const std::vector<int> driven{3, 1000, 2000};
  EXPECT_EQ(organ.pull(driven, organ.displaced(driven, Points(3, by))).violatedLinks, 0);
  for (std::size_t i = 0; i < organ.positions.size(); ++i)
    EXPECT_LT((organ.positions[i] - organ.mesh.points[i] - by).norm(), 1e-6f);
}

TEST(ChainmailExtremes, RigidPointsToldToPartTakeTheMiddle) {
  Organ organ(icosphere(2, kRadius), {kRigid});
  const ChainmailReport report = organ.pull({0, 3}, organ.displaced({0, 3}, {{0.02f, 0, 0}, {0.01f, 0, 0}}));
  EXPECT_GT(report.violatedLinks, 0);
  EXPECT_NEAR(report.worstViolation, 0.005f, 1e-6f);
  for (const int i : {1, 2, 50, 161})
    EXPECT_LT((organ.positions[i] - organ.mesh.points[i] - Eigen::Vector3f(0.015f, 0, 0)).norm(), 1e-6f);
}

TEST(ChainmailExtremes, AHundredMetresAwayNothingChanges) {
  const Eigen::Vector3f away(100, -100, 100);
  Organ here(icosphere(4, kRadius));
  TriangleMesh mesh = here.mesh;
  for (Eigen::Vector3f& p : mesh.points) p += away;
  Organ there(mesh);
  const std::vector<int> driven{0, 500, 2000};
  const Points by{{0.03f, 0.01f, 0}, {0, -0.02f, 0.02f}, {0, 0, 0.04f}};
  here.pull(driven, here.displaced(driven, by));
  const ChainmailReport report = there.pull(driven, there.displaced(driven, by));
  EXPECT_EQ(report.violatedLinks, 0);
  const float step = std::nextafter(100.0f, 200.0f) - 100.0f;  // of float at that distance
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    EXPECT_LE((there.positions[i] - away - here.positions[i]).cwiseAbs().maxCoeff(), 20 * step);

  ChainmailOptions moved;
  moved.frame.translation() = away.cast<double>();
  Points targets = here.displaced(driven, by);
  for (Eigen::Vector3f& p : targets) p += away;
  const Points straight = here.positions;
  EXPECT_EQ(here.pull(driven, targets, moved).violatedLinks, 0);
  for (std::size_t i = 0; i < straight.size(); ++i)
    EXPECT_LE((here.positions[i] - away - straight[i]).cwiseAbs().maxCoeff(), 4 * step);
}

TEST(ChainmailExtremes, TurningAHundredMetresAwayCostsOneStepOfFloat) {
  const Eigen::Vector3f away(100, -100, 100);
  TriangleMesh mesh = icosphere(3, kRadius);
  for (Eigen::Vector3f& p : mesh.points) p += away;
  Organ organ(mesh);
  const Eigen::Translation3d centre(away.cast<double>());
  ChainmailOptions turned;
  turned.frame = centre * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()) * centre.inverse();
  organ.pull({}, {}, turned);
  const float step = std::nextafter(100.0f, 200.0f) - 100.0f;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Eigen::Vector3d exact = turned.frame * mesh.points[i].cast<double>();
    EXPECT_LE((organ.positions[i].cast<double>() - exact).cwiseAbs().maxCoeff(), 1.01 * step);
  }
}

TEST(ChainmailExtremes, NumbersNearTheEndOfFloatStayFinite) {
  Organ organ(icosphere(2, kRadius), {ChainmailMaterial{0, 1e38f, 1e38f}});
  organ.pull({0, 3}, {{1e30f, -1e30f, 1e30f}, {-1e30f, 1e30f, 1e-40f}});
  expectFinite(organ.positions, 1.1e30f);
  Organ stiff(icosphere(2, kRadius), {kRigid});
  stiff.pull({0, 3}, {{1e30f, -1e30f, 1e30f}, {-1e30f, 1e30f, 1e-40f}});
  expectFinite(stiff.positions, 1.1e30f);
}

TEST(ChainmailExtremes, TenThousandBreathsDoNotDrift) {
  Organ organ(icosphere(2, kRadius), {kDiaphragm});
  const std::vector<int> driven{0, 3, 77};
  const auto breathe = [&](int step) {
    const float depth = 0.01f * (1 - std::cos(0.25f * std::numbers::pi_v<float> * float(step % 8)));
    organ.pull(driven, organ.displaced(driven, {{0, depth, 0}, {depth, 0, 0}, {0, 0, -depth}}));
    return organ.positions;
  };
  std::vector<Points> first;
  first.reserve(8);
  for (int step = 0; step < 8; ++step) first.push_back(breathe(step));
  EXPECT_NE(first[0], first[4]);
  for (int step = 8; step < 80000; ++step)
    organ.pull(driven, organ.displaced(driven, Points(3, {0, 0.001f * float(step % 7), 0})));
  for (int step = 0; step < 8; ++step)
    EXPECT_EQ(
        std::memcmp(breathe(step).data(), first[step].data(), sizeof first[step][0] * first[step].size()), 0);
}

}  // namespace
}  // namespace pleura
