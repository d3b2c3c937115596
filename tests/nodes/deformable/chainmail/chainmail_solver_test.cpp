#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "organ.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/chainmail/chainmail_solver.h>

namespace pleura {
namespace {

constexpr float kLungRadius = 0.1f;  // [m] about a lung's

bool sameBits(const Points& a, const Points& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

float largestDifference(const Points& a, const Points& b) {
  float largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).cwiseAbs().maxCoeff());
  return largest;
}

// Displacements that the links allow: the mean of some single pulls, since what they allow is convex.
struct FeasiblePull {
  std::vector<int> driven;
  Points targets;
};

FeasiblePull feasiblePull(Organ& organ, std::mt19937& random, int count) {
  const int points = static_cast<int>(organ.mesh.points.size());
  const FeasiblePull blank{randomPoints(random, count, points), {}};
  Points mean = organ.mesh.points;
  for (const int source : blank.driven) {
    organ.pull({source}, organ.displaced({source}, {randomVector(random, 0.05f)}));
    for (int i = 0; i < points; ++i) mean[i] += (organ.positions[i] - organ.mesh.points[i]) / float(count);
  }
  FeasiblePull pull = blank;
  for (const int i : pull.driven) pull.targets.push_back(mean[i]);
  return pull;
}

TEST(ChainmailSolver, OneDrivenPointIsExactAndTheRestFinite) {
  Organ organ(icosphere(3, kLungRadius));
  const Points targets{{0.03f, 0.11f, -0.02f}};
  const ChainmailReport report = organ.pull({7}, targets);
  EXPECT_EQ(organ.positions[7], targets[0]);
  EXPECT_GT(report.movedPoints, 1);
  for (const Eigen::Vector3f& p : organ.positions) EXPECT_LT(p.norm(), 1);
  EXPECT_EQ(report.violatedLinks, 0);
  EXPECT_EQ(violations(organ, organ.positions, 1e-7).count, 0);
}

TEST(ChainmailSolver, AlongAChainItIsClassicalChainMail) {
  std::mt19937 random(3);
  Points rest{{0, 0, 0}};
  std::vector<Eigen::Vector2i> edges;
  for (int i = 1; i < 40; ++i) {
    rest.push_back(rest.back() + randomVector(random, 0.01f));
    edges.emplace_back(i - 1, i);
  }
  const ChainmailMaterial m = kDiaphragm;
  const ChainmailModel model = makeChainmailModel(rest, linkEdges(rest, edges), std::span(&m, 1));
  ChainmailWorkspace workspace(40);
  Points positions(40), classical = rest;
  const std::vector<Eigen::Vector3f> targets{rest[0] + Eigen::Vector3f(0.02f, -0.015f, 0.01f)};
  solveChainmail(model, workspace, std::vector<int>{0}, targets, {}, positions);

  classical[0] = targets[0];
  for (int i = 1; i < 40; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3f d = rest[i] - rest[i - 1];
      const float s = m.shear * (d.cwiseAbs().sum() - std::abs(d[axis]));
      const float shortest = m.compression * std::abs(d[axis]) - s,
                  longest = m.stretch * std::abs(d[axis]) + s;
      const float low = d[axis] < 0 ? -longest : shortest, high = d[axis] < 0 ? -shortest : longest;
      classical[i][axis] =
          std::clamp(rest[i][axis], classical[i - 1][axis] + low, classical[i - 1][axis] + high);
    }
  EXPECT_LT(largestDifference(positions, classical), 1e-7f);
  EXPECT_GT(largestDifference(positions, rest), 0.01f);
}

// Where many pull, what one of them does next to itself is not averaged away.
TEST(ChainmailSolver, FullMotionIsKeptNextToEachOfManyContacts) {
  Organ organ(icosphere(5, 10));
  const std::vector<int> contacts{0, 1, 3, 5, 8};
  const Eigen::Vector3f up(0, 2, 0);
  const auto motionBeside = [&](int contact) {
    const auto& order = organ.model.order;
    const auto& topology = organ.model.topology;
    const int beside = order.outer[topology.neighbour[topology.begin[order.inner[contact]]]];
    return (organ.positions[beside] - organ.mesh.points[beside]).y();
  };
  organ.pull({0}, organ.displaced({0}, {up}));
  const float alone = motionBeside(0);
  EXPECT_GT(alone, 1.7f);
  for (const int count : {2, 3, 5}) {
    const std::vector<int> driven(contacts.begin(), contacts.begin() + count);
    const ChainmailReport report = organ.pull(driven, organ.displaced(driven, Points(count, up)));
    EXPECT_EQ(report.violatedLinks, 0);
    EXPECT_EQ(motionBeside(0), alone) << count;
    for (const int i : driven) EXPECT_EQ(organ.positions[i], organ.mesh.points[i] + up);
  }
}

TEST(ChainmailSolver, KeepsEveryLinkOfFeasiblePulls) {
  std::mt19937 random(11);
  for (const ChainmailMaterial& material : {ChainmailMaterial{}, kDiaphragm}) {
    Organ organ(icosphere(3, kLungRadius), {material});
    for (int trial = 0; trial < 60; ++trial) {
      const FeasiblePull pull = feasiblePull(organ, random, 1 + trial % 9);
      const ChainmailReport report = organ.pull(pull.driven, pull.targets);
      EXPECT_EQ(report.violatedLinks, 0) << trial;
      EXPECT_EQ(violations(organ, organ.positions, 1e-7).count, 0) << trial;
      for (std::size_t k = 0; k < pull.driven.size(); ++k)
        EXPECT_EQ(organ.positions[pull.driven[k]], pull.targets[k]);
    }
  }
}

// Floyd and Warshall's shortest paths give the bounds of every allowed shape; each point must be at the one
// nearest to its rest, or in the middle where the driven points contradict each other.
TEST(ChainmailSolver, MovesEachPointByTheLeastThatIsAllowed) {
  std::mt19937 random(5);
  Organ organ(icosphere(1, kLungRadius));
  const int n = static_cast<int>(organ.mesh.points.size());
  const ChainmailTopology& topology = organ.model.topology;
  for (int trial = 0; trial < 40; ++trial) {
    const std::vector<int> driven = randomPoints(random, 1 + trial % 5, n);
    Points by;
    for (std::size_t k = 0; k < driven.size(); ++k)
      by.push_back(randomVector(random, trial % 2 ? 0.3f : 0.03f));
    const Points targets = organ.displaced(driven, by);
    organ.pull(driven, targets);
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::MatrixXd distance = Eigen::MatrixXd::Constant(n, n, 1e9);
      for (int a = 0; a < n; ++a) {
        distance(a, a) = 0;
        for (int link = topology.begin[a]; link < topology.begin[a + 1]; ++link)
          distance(a, topology.neighbour[link]) = organ.model.slack[link][axis];
      }
      for (int k = 0; k < n; ++k)
        for (int a = 0; a < n; ++a)
          distance.row(a) =
              distance.row(a).cwiseMin(Eigen::RowVectorXd(distance.row(k).array() + distance(a, k)));
      for (int v = 0; v < n; ++v) {
        if (std::find(driven.begin(), driven.end(), v) != driven.end()) continue;
        double low = -1e9, high = 1e9;
        for (std::size_t k = 0; k < driven.size(); ++k) {
          const double u = double(targets[k][axis]) - organ.mesh.points[driven[k]][axis];
          const int i = organ.model.order.inner[driven[k]], inner = organ.model.order.inner[v];
          low = std::max(low, u - distance(i, inner));
          high = std::min(high, u + distance(inner, i));
        }
        const double expected = low > high ? (low + high) / 2 : std::clamp(0.0, low, high);
        EXPECT_NEAR(organ.positions[v][axis] - organ.mesh.points[v][axis], expected, 1e-7) << trial;
      }
    }
  }
}

TEST(ChainmailSolver, TheOrderOfDrivenPointsChangesNoBit) {
  std::mt19937 random(17);
  Organ organ(icosphere(3, kLungRadius));
  for (const float reach : {0.01f, 0.2f})
    for (const int sweeps : {0, 3}) {
      ChainmailOptions options;
      options.smoothingSweeps = sweeps;
      const std::vector<int> driven = randomPoints(random, 8, 642);
      Points by(8);
      for (Eigen::Vector3f& u : by) u = randomVector(random, reach);
      organ.pull(driven, organ.displaced(driven, by), options);
      const Points first = organ.positions;
      std::vector<int> order(8);
      std::iota(order.begin(), order.end(), 0);
      for (int trial = 0; trial < 10; ++trial) {
        std::shuffle(order.begin(), order.end(), random);
        std::vector<int> shuffled;
        Points shuffledBy;
        for (const int k : order) {
          shuffled.push_back(driven[k]);
          shuffledBy.push_back(by[k]);
        }
        organ.pull(shuffled, organ.displaced(shuffled, shuffledBy), options);
        EXPECT_TRUE(sameBits(organ.positions, first));
      }
    }
}

TEST(ChainmailSolver, TheNumberingOfPointsChangesNoBit) {
  std::mt19937 random(19);
  Organ organ(icosphere(3, kLungRadius));
  std::vector<int> number(642);
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  TriangleMesh renumbered = organ.mesh;
  for (int i = 0; i < 642; ++i) renumbered.points[number[i]] = organ.mesh.points[i];
  for (Eigen::Vector3i& t : renumbered.triangles) t = {number[t[2]], number[t[0]], number[t[1]]};
  std::shuffle(renumbered.triangles.begin(), renumbered.triangles.end(), random);
  Organ other(renumbered);

  const std::vector<int> driven{3, 99, 500};
  const Points targets = organ.displaced(driven, {{0.04f, 0, 0}, {0, 0.05f, 0.01f}, {0, 0, -0.06f}});
  organ.pull(driven, targets);
  other.pull({number[3], number[99], number[500]}, targets);
  for (int i = 0; i < 642; ++i) EXPECT_EQ(organ.positions[i], other.positions[number[i]]);
}

TEST(ChainmailSolver, ATurnedBodyAtRestViolatesNoLink) {
  Organ organ(icosphere(5, 10));
  ChainmailOptions options;
  options.frame.linear() = Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()).matrix();
  const std::vector<int> driven{0, 40, 900, 7000};
  Points targets;
  for (const int i : driven)
    targets.push_back((options.frame * organ.mesh.points[i].cast<double>()).cast<float>());
  const ChainmailReport report = organ.pull(driven, targets, options);
  EXPECT_EQ(report.violatedLinks, 0);
  EXPECT_EQ(violations(organ, organ.positions, 1e-5, options.frame.linear()).count, 0);
  EXPECT_GT(violations(organ, organ.positions, 1e-5).count, 10000) << "axis-aligned boxes should not hold";
}

TEST(ChainmailSolver, TurningEverythingTurnsTheAnswer) {
  std::mt19937 random(23);
  Organ organ(icosphere(3, kLungRadius));
  ChainmailOptions turned;
  turned.frame =
      Eigen::Translation3d(0.3, -0.2, 0.5) * Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized());
  for (int trial = 0; trial < 10; ++trial) {
    const FeasiblePull pull = feasiblePull(organ, random, 4);
    organ.pull(pull.driven, pull.targets);
    const Points straight = organ.positions;
    Points targets;
    for (const Eigen::Vector3f& p : pull.targets)
      targets.push_back((turned.frame * p.cast<double>()).cast<float>());
    EXPECT_EQ(organ.pull(pull.driven, targets, turned).violatedLinks, 0);
    for (std::size_t i = 0; i < straight.size(); ++i)
      EXPECT_LT(((turned.frame * straight[i].cast<double>()).cast<float>() - organ.positions[i]).norm(),
                5e-7f);
  }
}

TEST(ChainmailSolver, ExhaleReturnsExactlyToRest) {
  Organ organ(icosphere(4, kLungRadius));
  const std::vector<int> driven{5, 700, 2000};
  organ.pull(driven, organ.displaced(driven, Points(3, {0.03f, 0.02f, 0})));
  EXPECT_FALSE(sameBits(organ.positions, organ.mesh.points));
  const ChainmailReport report = organ.pull(driven, organ.displaced(driven, Points(3, {0, 0, 0})));
  EXPECT_TRUE(sameBits(organ.positions, organ.mesh.points));
  EXPECT_EQ(report.movedPoints, 0);
}

TEST(ChainmailSolver, WhatNobodyPullsStaysAtRestToTheBit) {
  Organ organ(icosphere(4, kLungRadius));
  const ChainmailReport report = organ.pull({0}, organ.displaced({0}, {{0.004f, 0, 0}}));
  int moved = 0;
  for (std::size_t i = 0; i < organ.positions.size(); ++i)
    moved += organ.positions[i] != organ.mesh.points[i];
  EXPECT_EQ(moved, report.movedPoints);
  EXPECT_LT(moved, 200);
  EXPECT_LT(report.visits, 2 * moved);
}

// Contradiction: two points are torn apart farther than the links between them stretch.
TEST(ChainmailSolver, ContradictionsAreReportedAndStayAtTheDrivenPoints) {
  Organ organ(icosphere(3, kLungRadius));
  const std::vector<int> driven{0, 300};
  const Points targets = organ.displaced(driven, {{2, 0, 0}, {-2, 1, 0}});
  const ChainmailReport report = organ.pull(driven, targets);
  EXPECT_EQ(organ.positions[0], targets[0]);
  EXPECT_EQ(organ.positions[300], targets[1]);
  const Violations measured = violations(organ, organ.positions, 4e-6);
  EXPECT_EQ(report.violatedLinks, measured.count);
  EXPECT_NEAR(report.worstViolation, measured.worst, 1e-5);
  EXPECT_GT(report.violatedLinks, 0);
  EXPECT_LE(report.violatedLinks, 12) << "only the links of the two";
}

TEST(ChainmailSolver, ContradictionsBeginWithoutAJump) {
  Organ organ(icosphere(2, kLungRadius));
  const std::vector<int> driven{0, 3};
  Points before = organ.positions;
  bool wasKept = true, isKept = true;
  for (int step = 0; step <= 400; ++step) {
    const float pull = 0.0005f * static_cast<float>(step);
    isKept = organ.pull(driven, organ.displaced(driven, {{0, pull, 0}, {0, -pull, pull}})).violatedLinks == 0;
    EXPECT_TRUE(wasKept || !isKept) << "more pull mended a contradiction";
    EXPECT_LT(largestDifference(before, organ.positions), 0.0006f) << step;
    before = organ.positions;
    wasKept = isKept;
  }
  EXPECT_FALSE(isKept);
}

TEST(ChainmailSolver, RigidPointsMoveAsOne) {
  TriangleMesh mesh = icosphere(3, kLungRadius);
  std::vector<ChainmailMaterial> material(mesh.points.size());
  std::vector<int> cap;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (mesh.points[i].y() > 0.08f) {
      material[i] = kRigid;
      cap.push_back(static_cast<int>(i));
    }
  ASSERT_GT(cap.size(), 20u);
  Organ organ(mesh, material);
  const Eigen::Vector3f by(0.01f, -0.02f, 0.005f);
  EXPECT_EQ(organ.pull({cap[3]}, organ.displaced({cap[3]}, {by})).violatedLinks, 0);
  for (const int i : cap) EXPECT_LT((organ.positions[i] - mesh.points[i] - by).norm(), 1e-7f);
}

// Energy of the displacement's differences along links.
double roughness(const Organ& organ, const Points& positions) {
  double sum = 0;
  for (const Eigen::Vector3i& t : organ.mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      sum += (positions[a] - organ.mesh.points[a] - positions[b] + organ.mesh.points[b]).squaredNorm();
    }
  return sum;
}

TEST(ChainmailSolver, SmoothingSmoothsAndKeepsTheLimits) {
  std::mt19937 random(29);
  Organ organ(icosphere(4, kLungRadius));
  for (int trial = 0; trial < 20; ++trial) {
    const FeasiblePull pull = feasiblePull(organ, random, 5);
    organ.pull(pull.driven, pull.targets);
    double before = roughness(organ, organ.positions);
    for (const int sweeps : {1, 4, 16}) {
      ChainmailOptions options;
      options.smoothingSweeps = sweeps;
      EXPECT_EQ(organ.pull(pull.driven, pull.targets, options).violatedLinks, 0);
      EXPECT_EQ(violations(organ, organ.positions, 1e-7).count, 0);
      for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(organ.positions[pull.driven[k]], pull.targets[k]);
      EXPECT_LT(roughness(organ, organ.positions), before);
      before = roughness(organ, organ.positions);
    }
  }
}

TEST(ChainmailSolver, RefusesWhatItCannotUseAndKeepsTheLastShape) {
  Organ organ(icosphere(2, kLungRadius));
  organ.pull({4}, organ.displaced({4}, {{0.02f, 0, 0}}));
  const Points last = organ.positions;
  const Eigen::Vector3f p(0, 0.1f, 0);
  const auto refused = [&](const std::vector<int>& driven, const Points& targets,
                           const ChainmailOptions& options = {}) {
    EXPECT_THROW(organ.pull(driven, targets, options), std::invalid_argument);
    EXPECT_TRUE(sameBits(organ.positions, last));
  };
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e35f})
    refused({0, 1}, {p, {0, bad, 0}});
  refused({-1}, {p});
  refused({162}, {p});
  refused({0, 1}, {p});
  refused({3, 0, 3}, {p, p, 2 * p});
  ChainmailOptions options;
  options.smoothingSweeps = -1;
  refused({0}, {p}, options);
  options = {};
  options.frame.linear() *= 2;
  refused({0}, {p}, options);
  options.frame.linear() = Eigen::Vector3d(1, 1, -1).asDiagonal();
  refused({0}, {p}, options);
  options.frame.linear()(1, 1) = std::numeric_limits<double>::quiet_NaN();
  refused({0}, {p}, options);
  Points tooFew(3);
  EXPECT_THROW(solveChainmail(organ.model, organ.workspace, std::vector<int>{0}, Points{p}, {}, tooFew),
               std::invalid_argument);
  ChainmailWorkspace small(3);
  EXPECT_THROW(solveChainmail(organ.model, small, std::vector<int>{0}, Points{p}, {}, organ.positions),
               std::invalid_argument);
  organ.pull({4}, organ.displaced({4}, {{0.02f, 0, 0}}));
  EXPECT_TRUE(sameBits(organ.positions, last)) << "a refused solve left something behind";
}

TEST(ChainmailSolver, APointDrivenTwiceToOnePlaceIsDrivenOnce) {
  Organ organ(icosphere(2, kLungRadius));
  const Eigen::Vector3f p(0.05f, 0.1f, 0);
  organ.pull({9}, {p});
  const Points once = organ.positions;
  organ.pull({9, 9}, {p, p});
  EXPECT_TRUE(sameBits(organ.positions, once));
}

TEST(ChainmailSolver, EarlierSolvesLeaveNoTrace) {
  std::mt19937 random(31);
  Organ worn(icosphere(3, kLungRadius));
  for (int trial = 0; trial < 30; ++trial) {
    const std::vector<int> driven = randomPoints(random, trial % 7, 642);
    Points by(driven.size());
    for (Eigen::Vector3f& u : by) u = randomVector(random, trial % 3 ? 0.02f : 0.5f);
    ChainmailOptions options;
    options.smoothingSweeps = trial % 2;
    Organ fresh(worn.mesh);
    worn.pull(driven, worn.displaced(driven, by), options);
    fresh.pull(driven, fresh.displaced(driven, by), options);
    EXPECT_TRUE(sameBits(worn.positions, fresh.positions)) << trial;
  }
}

}  // namespace
}  // namespace pleura
