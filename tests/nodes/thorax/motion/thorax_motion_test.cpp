#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>

#include "../anatomy/obj_reader.h"
#include "contact_probe.h"
#include <gtest/gtest.h>

#include <pleura/nodes/thorax/anatomy/from_meshes.h>
#include <pleura/nodes/thorax/motion/cartilage_bend.h>
#include <pleura/nodes/thorax/motion/thorax_motion.h>

namespace pleura {
namespace {

// A breath: 0.4-0.6 L of air in a quiet one, 2.5-4 L to total lung capacity.
constexpr double kQuiet = 1.0 / 7.0;  // of the way from FRC to TLC
constexpr int kSteps = 20;

std::filesystem::path meshDirectory() {
  const char* shared = std::getenv("PLEURA_SHARED");
  const std::filesystem::path root =
      shared ? shared : std::filesystem::path(PLEURA_SOURCE_DIR) / ".." / "shared";
  return root / "anatomy";
}

struct State {
  std::vector<Eigen::Vector3f> diaphragm, left, right;
  bool operator==(const State&) const = default;
};

double enclosed(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3i>& triangles) {
  double sum = 0.0;  // sum a . (b x c) / 6
  for (const Eigen::Vector3i& t : triangles) {
    const auto p = [&](int k) -> Eigen::Vector3d {
      return points[static_cast<std::size_t>(t[k])].cast<double>();
    };
    sum += p(0).dot(p(1).cross(p(2))) / 6.0;
  }
  return sum;
}

enum class From { Figures, Meshes };

/// The same physics on the generated thorax and on the scanned one. Each is built once: it has no memory.
class ThoraxMotionOf : public ::testing::TestWithParam<From> {
 protected:
  struct Thorax {
    Anatomy anatomy;
    ThoraxMotion motion{anatomy};
  };

  void SetUp() override {
    if (GetParam() == From::Meshes && !std::filesystem::is_directory(meshDirectory() / "skeleton")) {
      GTEST_SKIP() << "no real meshes at " << meshDirectory() << "; set PLEURA_SHARED";
    }
  }

  Thorax& thorax() {
    static std::array<std::optional<Thorax>, 2> built;
    std::optional<Thorax>& one = built[GetParam() == From::Figures ? 0 : 1];
    if (!one) {
      one.emplace(Thorax{GetParam() == From::Figures ? generateAnatomy()
                                                     : anatomyFromMeshes(meshDirectory(), readObj)});
    }
    return *one;
  }

  State at(double inflation) {
    thorax().motion.evaluate(inflation);
    return {thorax().motion.diaphragm(), thorax().motion.lung(0), thorax().motion.lung(1)};
  }

  double lungVolume(double inflation) {
    const State state = at(inflation);
    return enclosed(state.left, thorax().anatomy.lungs[0].mesh.triangles) +
           enclosed(state.right, thorax().anatomy.lungs[1].mesh.triangles);
  }

  /// How far the highest point of the dome on a side has come down [m].
  double excursion(Side side, double inflation) {
    const auto& rest = thorax().anatomy.diaphragm.mesh.points;
    std::size_t top = rest.size();
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (rest[i].x() * sign(side) > 0.0f && (top == rest.size() || rest[i].y() > rest[top].y())) top = i;
    }
    return rest[top].y() - at(inflation).diaphragm[top].y();
  }
};

TEST_P(ThoraxMotionOf, RestsBitForBitAtInflationZero) {
  at(0.8);
  const State rest = at(0.0);
  EXPECT_EQ(rest.diaphragm, thorax().anatomy.diaphragm.mesh.points);
  EXPECT_EQ(rest.left, thorax().anatomy.lungs[0].mesh.points);
  EXPECT_EQ(rest.right, thorax().anatomy.lungs[1].mesh.points);
}

TEST_P(ThoraxMotionOf, HasNoMemory) {
  const State first = at(0.6);
  at(1.0);
  at(0.05);
  EXPECT_TRUE(at(0.6) == first);
  ThoraxMotion other(thorax().anatomy);
  other.evaluate(0.6);
  EXPECT_EQ(other.diaphragm(), first.diaphragm);
  EXPECT_EQ(other.lung(0), first.left);
}

TEST_P(ThoraxMotionOf, IsSmoothInInflation) {
  // |x(i + h) - 2 x(i) + x(i - h)| of a curve bending by at most half a metre per unit squared
  constexpr double h = 0.02;
  for (const double i : {0.02, 0.14, 0.5, 0.9}) {
    const State a = at(i - h);
    const State b = at(i);
    const State c = at(i + h);
    for (std::size_t k = 0; k < b.left.size(); ++k) {
      EXPECT_LT((a.left[k] - 2.0f * b.left[k] + c.left[k]).norm(), 0.002f) << k << " at " << i;
    }
  }
}

TEST_P(ThoraxMotionOf, TheDomeDescendsAsMeasured) {
  for (const Side side : {Side::Left, Side::Right}) {
    EXPECT_GT(excursion(side, kQuiet), 0.008);  // quiet 0.8-2.1 cm
    EXPECT_LT(excursion(side, kQuiet), 0.021);
    EXPECT_GT(excursion(side, 1.0), 0.050);  // deep 5-8.6 cm
    EXPECT_LT(excursion(side, 1.0), 0.086);
  }
}

TEST_P(ThoraxMotionOf, BreathesTheMeasuredVolumes) {
  const double rest = lungVolume(0.0);
  const double tidal = lungVolume(kQuiet) - rest;
  const double capacity = lungVolume(1.0) - rest;
  RecordProperty("tidal_mL", static_cast<int>(tidal * 1e6));
  RecordProperty("inspiratory_capacity_mL", static_cast<int>(capacity * 1e6));
  EXPECT_GT(tidal, 0.4e-3);
  EXPECT_LT(tidal, 0.6e-3);
  EXPECT_GT(capacity, 2.5e-3);
  EXPECT_LT(capacity, 4.0e-3);
  for (int k = 1; k <= kSteps; ++k) {
    EXPECT_GT(lungVolume(static_cast<double>(k) / kSteps), lungVolume(static_cast<double>(k - 1) / kSteps));
  }
}

TEST_P(ThoraxMotionOf, SternumGoesUpAndForwardsWithoutSwaying) {
  const BodyMotions bodies = thorax().motion.cage().bodies(1.0);
  const Eigen::Vector3d rest = thorax().anatomy.sternum.sternalAngle.cast<double>();
  const Eigen::Vector3d moved = bodies[kSternum] * rest;
  EXPECT_GT(moved.y(), rest.y() + 0.005);
  EXPECT_GT(moved.z(), rest.z() + 0.005);
  EXPECT_NEAR(moved.x(), rest.x(), 0.001);
}

TEST_P(ThoraxMotionOf, TheCageWidensOnBothSides) {
  for (const Rib& part : thorax().anatomy.ribs) {
    const BodyMotions bodies = thorax().motion.cage().bodies(1.0);
    const Eigen::Isometry3d& motion = bodies[static_cast<std::size_t>(ribBody(part.side, part.number))];
    double widest = 0.0;
    double widestNow = 0.0;
    for (const Eigen::Vector3f& p : part.centreline) {
      widest = std::max(widest, static_cast<double>(sign(part.side) * p.x()));
      widestNow = std::max(widestNow, sign(part.side) * (motion * p.cast<double>()).x());
    }
    EXPECT_GT(widestNow, widest) << part.name;
  }
}

TEST_P(ThoraxMotionOf, CartilagesStayAttachedAtBothEnds) {
  const Anatomy& anatomy = thorax().anatomy;
  for (int k = 0; k <= kSteps; ++k) {
    const BodyMotions motions = thorax().motion.cage().bodies(static_cast<double>(k) / kSteps);
    const BodyDisplacements displacements = displacementsOf(motions);
    const auto moved = [&](std::size_t index) {
      const TriangleMesh& mesh = anatomy.cartilages[index].mesh;
      std::vector<Eigen::Vector3f> now(mesh.points.size());
      carryAll(mesh.points, thorax().motion.cage().cartilageWeights(index), displacements, now);
      return now;
    };
    for (std::size_t c = 0; c < anatomy.cartilages.size(); ++c) {
      const Cartilage& part = anatomy.cartilages[c];
      const std::vector<Eigen::Vector3f> now = moved(c);
      const std::size_t above = c - 1;  // the cartilage it joins, when it joins one
      const std::vector<Eigen::Vector3f> aboveNow = part.joins > 0 ? moved(above) : now;
      for (std::size_t i = 0; i < now.size(); ++i) {
        const Eigen::Vector3d rest = part.mesh.points[i].cast<double>();
        const double t = fractionAlong(part.centreline, part.mesh.points[i]);
        const auto off = [&](const Eigen::Vector3d& where) { return (now[i].cast<double>() - where).norm(); };
        if (t == 0.0) {
          EXPECT_LT(off(motions[static_cast<std::size_t>(ribBody(part.side, part.number))] * rest), 1e-3);
        }
        if (t == 1.0 && part.joins == 0) {
          EXPECT_LT(off(motions[kSternum] * rest), 1e-3);
        }
      }
      if (part.joins == 0) continue;
      const auto& aboveRest = anatomy.cartilages[above].mesh.points;
      const SurfaceQuery before(aboveRest, anatomy.cartilages[above].mesh.triangles);
      const SurfaceQuery after(aboveNow, anatomy.cartilages[above].mesh.triangles);
      for (std::size_t i = 0; i < now.size(); ++i) {
        if (fractionAlong(part.centreline, part.mesh.points[i]) < 1.0) continue;
        const double gap = after.closestPoint(now[i].cast<double>()).distance -
                           before.closestPoint(part.mesh.points[i].cast<double>()).distance;
        EXPECT_LT(gap, 1e-3) << part.name;
      }
    }
  }
}

TEST_P(ThoraxMotionOf, OrgansFollowTheCageWithoutGapsOrPenetration) {
  constexpr double kGap = 0.003;          // [m] more than at rest
  constexpr double kPenetration = 0.001;  // [m]
  ContactProbe probe(thorax().anatomy, thorax().motion);
  std::vector<double> inflations{kQuiet};
  for (int k = 0; k <= kSteps; ++k) inflations.push_back(static_cast<double>(k) / kSteps);
  for (const double inflation : inflations) {
    const Contact contact = probe.measure(inflation);
    const auto keeps = [&](const Worst& worst, double bound) {
      EXPECT_LT(worst.value, bound) << worst.where << ", inflation " << inflation;
    };
    keeps(contact.gapGrowth, kGap);
    keeps(contact.gapOfEdges, kGap);
    keeps(contact.liftOff, kGap);
    keeps(contact.penetration, kPenetration);
    keeps(contact.throughWall, kPenetration);
  }
}

TEST_P(ThoraxMotionOf, TheZoneOfAppositionShortens) {
  // Height of the fold above the rim in the middle of the lateral wall, from the diaphragm's own points.
  const Diaphragm& diaphragm = thorax().anatomy.diaphragm;
  const auto height = [&](double inflation) {
    const State state = at(inflation);
    double wall = 0.0;
    int count = 0;
    double rim = 0.0;
    int rims = 0;
    for (std::size_t i = 0; i < diaphragm.part.size(); ++i) {
      if (diaphragm.mesh.points[i].x() < 0.09f) continue;
      if (diaphragm.s[i] > 1.0f && diaphragm.s[i] < 1.3f) {
        wall += state.diaphragm[i].y();
        ++count;
      } else if (diaphragm.part[i] == DiaphragmPart::Rim) {
        rim += state.diaphragm[i].y();
        ++rims;
      }
    }
    return wall / count - rim / rims;
  };
  const double rest = height(0.0);
  EXPECT_LT(height(kQuiet), rest);
  EXPECT_LT(height(1.0), 0.7 * rest);
  EXPECT_GT(height(1.0), 0.0);
}

TEST_P(ThoraxMotionOf, RefusesAnInflationThatIsNotFinite) {
  EXPECT_THROW(thorax().motion.evaluate(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST_P(ThoraxMotionOf, PlaysTheThesisAmplitudesToo) {
  ThoraxMotion motion(thorax().anatomy, {}, thesisRibAngles(1.0), thesisRibAngles(-1.0));
  motion.evaluate(1.0);
  EXPECT_GT(
      enclosed(motion.lung(0), thorax().anatomy.lungs[0].mesh.triangles),
      enclosed(thorax().anatomy.lungs[0].mesh.points, thorax().anatomy.lungs[0].mesh.triangles) + 0.8e-3);
}

INSTANTIATE_TEST_SUITE_P(Anatomies, ThoraxMotionOf, ::testing::Values(From::Figures, From::Meshes),
                         [](const auto& test) {
                           return test.param == From::Figures ? "Generated" : "Scanned";
                         });

}  // namespace
}  // namespace pleura
