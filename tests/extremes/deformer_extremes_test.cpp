#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/chainmail_deformer.h>
#include <pleura/nodes/deformable/finite_element_deformer.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/spring_deformer.h>
#include <pleura/tests/nodes/deformable/chainmail/icosphere.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

using Points = std::vector<Vec3f>;

/// A tier, made by its node type and the fields that make it one.
struct Tier {
  const char* name;
  std::shared_ptr<DeformerNode> (*make)(TestContext&);
};

template <class T>
std::shared_ptr<DeformerNode> withFields(TestContext& context,
                                         const std::vector<std::array<const char*, 2>>& fields) {
  return context.make<T>([&](T& node) {
    for (const auto& [field, text] : fields) node.getField(field)->setValueFromString(text);
  });
}

const Tier kTiers[] = {
    {"ChainMail", [](TestContext& c) { return withFields<ChainmailDeformer>(c, {}); }},
    {"springs", [](TestContext& c) { return withFields<SpringDeformer>(c, {}); }},
    {"springs, volume held",
     [](TestContext& c) {
       return withFields<SpringDeformer>(c, {{"interior", "VOLUME"}});
     }},
    {"linear FEM",
     [](TestContext& c) {
       return withFields<FiniteElementDeformer>(c, {{"model", "LINEAR"}, {"elements", "200"}});
     }},
    {"linear tetrahedra",
     [](TestContext& c) {
       return withFields<FiniteElementDeformer>(
           c, {{"model", "LINEAR"}, {"elementType", "TETRAHEDRON"}, {"elements", "1000"}});
     }},
    {"linear FEM, nu 0.4999",
     [](TestContext& c) {
       return withFields<FiniteElementDeformer>(
           c, {{"model", "LINEAR"}, {"elements", "200"}, {"poissonRatio", "0.4999"}});
     }},
    {"corotational FEM",
     [](TestContext& c) {
       return withFields<FiniteElementDeformer>(c, {{"model", "COROTATIONAL"}, {"elements", "100"}});
     }},
    {"Neo-Hookean FEM", [](TestContext& c) {
       return withFields<FiniteElementDeformer>(c, {{"model", "NEO_HOOKEAN"}, {"elements", "100"}});
     }}};

void PrintTo(const Tier& tier, std::ostream* out) { *out << tier.name; }

/// What is done to the driven points of a ball of 5 cm.
struct Extreme {
  const char* name;
  Vec3f (*move)(const Vec3f& rest, std::mt19937& random);
};

Vec3f turned(const Vec3f& p, float angle) { return Eigen::AngleAxisf(angle, Vec3f::UnitZ()) * p; }

const Extreme kExtremes[] = {
    {"at rest", [](const Vec3f& p, std::mt19937&) { return p; }},
    {"scrambled",
     [](const Vec3f&, std::mt19937& random) {
       std::uniform_real_distribution<float> anywhere(-0.05f, 0.05f);
       return Vec3f(anywhere(random), anywhere(random), anywhere(random));
     }},
    {"collapsed to a plane", [](const Vec3f& p, std::mt19937&) { return Vec3f(p.x(), p.y(), 0); }},
    {"collapsed to a line", [](const Vec3f& p, std::mt19937&) { return Vec3f(p.x(), 0, 0); }},
    {"collapsed to a point", [](const Vec3f&, std::mt19937&) { return Vec3f(0, 0, 0); }},
    {"mirrored", [](const Vec3f& p, std::mt19937&) { return Vec3f(-p.x(), p.y(), p.z()); }},
    {"stretched tenfold", [](const Vec3f& p, std::mt19937&) { return Vec3f(10 * p.x(), p.y(), p.z()); }},
    {"twisted by 360 degrees",
     [](const Vec3f& p, std::mt19937&) { return turned(p, static_cast<float>(M_PI) * p.z() / 0.05f); }},
    {"turned by 90 degrees",
     [](const Vec3f& p, std::mt19937&) { return turned(p, static_cast<float>(M_PI) / 2); }},
    {"100 m away", [](const Vec3f& p, std::mt19937&) { return Vec3f(p + Vec3f(100, 0, 0)); }}};

double farthest(const Points& a, const Points& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max<double>(most, (a[i] - b[i]).norm());
  return most;
}

bool allFinite(const Points& points) {
  return std::all_of(points.begin(), points.end(), [](const Vec3f& p) { return isFinite(p); });
}

std::string numberOf(DeformerNode& node, const char* field) {
  Field* found = node.getField(field);
  return found != nullptr ? found->getValueAsString() : "-";
}

class DeformerExtremes : public ::testing::TestWithParam<Tier> {
 protected:
  DeformerExtremes() : ball(icosphere(3, 0.05f)) {
    for (int i = 0; i < static_cast<int>(ball.points.size()); i += 7) driven.push_back(i);
  }

  Points targetsOf(const Extreme& extreme) {
    std::mt19937 random(1);
    Points targets;
    for (const int i : driven)
      targets.push_back(extreme.move(ball.points[static_cast<std::size_t>(i)], random));
    return targets;
  }

  TestContext context;
  TriangleMesh ball;
  std::vector<int> driven;
};

TEST_P(DeformerExtremes, StaysFiniteAndRecovers) {
  const auto deformer = GetParam().make(context);
  deformer->setRest(ball, {});
  for (const Extreme& extreme : kExtremes) {
    const Points targets = targetsOf(extreme);
    Points shape = ball.points;
    deformer->deform(driven, targets, shape);
    const bool isFine = allFinite(shape);
    const std::string iterations = numberOf(*deformer, "iterations"),
                      residual = numberOf(*deformer, "residual"),
                      converged = numberOf(*deformer, "converged");
    for (std::size_t i = 0; i < driven.size(); ++i)
      EXPECT_EQ(shape[static_cast<std::size_t>(driven[i])], targets[i]) << extreme.name;
    Points after = ball.points;
    deformer->deform(driven, targetsOf(kExtremes[0]), after);
    const double left = farthest(after, ball.points);
    fmt::print(
        "{:24} {:24} finite {}  iterations {:>4}  residual {:>10}  converged {:5}  left after return {:.1e} "
        "m\n",
        GetParam().name, extreme.name, isFine ? "yes" : "NO ", iterations, residual, converged, left);
    EXPECT_TRUE(isFine) << extreme.name;
    EXPECT_LT(left, 1e-6) << extreme.name;
  }
}

TEST_P(DeformerExtremes, RefusesWhatIsNoNumberAndKeepsTheShape) {
  const auto deformer = GetParam().make(context);
  deformer->setRest(ball, {});
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Points targets = targetsOf(kExtremes[0]);
    targets[3].y() = bad;
    Points shape(ball.points.size(), Vec3f(1, 2, 3));
    const Points before = shape;
    EXPECT_THROW(deformer->deform(driven, targets, shape), std::invalid_argument);
    EXPECT_EQ(shape, before);
  }
}

TEST_P(DeformerExtremes, NoneOneAndAllPointsMayBeDriven) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, ball.points.size()}) {
    const auto deformer = GetParam().make(context);
    deformer->setRest(ball, {});
    driven.clear();
    for (std::size_t i = 0; i < count; ++i) driven.push_back(static_cast<int>(i));
    Points targets;
    for (const int i : driven)
      targets.push_back(ball.points[static_cast<std::size_t>(i)] + Vec3f(0.001f, 0, 0));
    Points shape = ball.points;
    deformer->deform(driven, targets, shape);
    EXPECT_TRUE(allFinite(shape)) << count;
    for (std::size_t i = 0; i < driven.size(); ++i) EXPECT_EQ(shape[i], targets[i]) << count;
  }
}

TEST_P(DeformerExtremes, TheOrderOfDrivenPointsDoesNotMatter) {
  const Extreme pull{"pull", [](const Vec3f& p, std::mt19937&) { return Vec3f(1.1f * p); }};
  Points targets = targetsOf(pull);
  Points shapes[2];
  for (Points& shape : shapes) {
    const auto deformer = GetParam().make(context);
    deformer->setRest(ball, {});
    shape = ball.points;
    deformer->deform(driven, targets, shape);
    std::reverse(driven.begin(), driven.end());
    std::reverse(targets.begin(), targets.end());
  }
  EXPECT_LT(farthest(shapes[0], shapes[1]), 1e-6);
}

TEST_P(DeformerExtremes, RepeatedIsTheSameBitForBit) {
  const auto deformer = GetParam().make(context);
  deformer->setRest(ball, {});
  Points first = ball.points, second = ball.points, between = ball.points;
  deformer->deform(driven, targetsOf(kExtremes[2]), first);
  deformer->deform(driven, targetsOf(kExtremes[6]), between);
  deformer->deform(driven, targetsOf(kExtremes[2]), second);
  EXPECT_EQ(first, second);
}

/// Organs that move with inertia: the shape is that of the moment, whatever the step.
class MovingExtremes : public DeformerExtremes {
 protected:
  std::shared_ptr<DeformerNode> moving() {
    auto deformer = GetParam().make(context);
    deformer->getField("quasiStatic")->setValueFromString("false");
    deformer->setRest(ball, {});
    advance(*deformer, 0, kExtremes[0]);
    return deformer;
  }

  Points advance(DeformerNode& deformer, double step, const Extreme& extreme) {
    context.tick(now_ += step);
    Points shape = ball.points;
    deformer.deform(driven, targetsOf(extreme), shape);
    return shape;
  }

 private:
  double now_ = 0;
};

TEST_P(MovingExtremes, StaysFiniteAtAnyStepOfTimeAndComesToRest) {
  for (const double step : {1e-6, 1e-2, 1e3}) {
    const auto deformer = moving();
    bool isFine = true;
    for (const Extreme& extreme : kExtremes)
      for (int k = 0; k < 3; ++k) isFine = isFine && allFinite(advance(*deformer, step, extreme));
    double left = 0;
    for (int k = 0; k < 3; ++k) left = farthest(advance(*deformer, 1e3, kExtremes[0]), ball.points);
    fmt::print("{:24} steps of {:g} s  finite {}  residual {:>10}  converged {:5}  left at rest {:.1e} m\n",
               GetParam().name, step, isFine ? "yes" : "NO ", numberOf(*deformer, "residual"),
               numberOf(*deformer, "converged"), left);
    EXPECT_TRUE(isFine) << step;
    EXPECT_LT(left, 1e-6) << step;
  }
}

TEST_P(MovingExtremes, ALongStepIsTheStaticAnswer) {
  const Extreme pull{"pull", [](const Vec3f& p, std::mt19937&) { return Vec3f(1.1f * p.x(), p.y(), p.z()); }};
  const auto still = GetParam().make(context);
  still->setRest(ball, {});
  const auto deformer = moving();
  const Points moved = advance(*deformer, 1e6, pull), expected = advance(*still, 0, pull);
  EXPECT_LT(farthest(moved, expected), 1e-6);
  EXPECT_GT(farthest(moved, ball.points), 1e-3);
}

const auto kMovingTiers = std::vector<Tier>(std::begin(kTiers) + 3, std::end(kTiers));

INSTANTIATE_TEST_SUITE_P(Tiers, MovingExtremes, ::testing::ValuesIn(kMovingTiers),
                         [](const auto& test) { return std::to_string(test.index); });

INSTANTIATE_TEST_SUITE_P(Tiers, DeformerExtremes, ::testing::ValuesIn(kTiers),
                         [](const auto& test) { return std::to_string(test.index); });

}  // namespace
}  // namespace pleura
