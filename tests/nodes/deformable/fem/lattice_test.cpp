#include <algorithm>
#include <limits>
#include <set>

#include "bodies.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/lattice.h>

namespace pleura {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3f;
using testing::HasSubstr;

/// Every element is the cube of its cell, its corners in the order of bits; no node is left over.
void expectSound(const Lattice& lattice) {
  const SolidMesh& solid = lattice.solid;
  const double h = lattice.grid.cellSize;
  ASSERT_EQ(solid.nodesPerElement, 8);
  ASSERT_EQ(solid.fill.size(), static_cast<std::size_t>(solid.elementCount()));
  EXPECT_EQ(lattice.report.elements, solid.elementCount());
  std::vector<bool> used(solid.nodes.size(), false);
  int elements = 0;
  for (int cell = 0; cell < lattice.grid.cellCount(); ++cell) {
    const int e = lattice.elementOf[cell];
    if (e < 0) continue;
    EXPECT_EQ(e, elements++);
    EXPECT_GT(solid.fill[e], 0);
    EXPECT_LE(solid.fill[e], 1);
    for (int k = 0; k < 8; ++k) {
      const int node = solid.elements[8 * e + k];
      const Vector3d corner = lattice.grid.cellOf(cell).cast<double>() + Vector3d(k & 1, k >> 1 & 1, k >> 2);
      EXPECT_LE((solid.nodes.at(node) - lattice.grid.origin - h * corner).norm(), 1e-9 * h);
      used[node] = true;
    }
  }
  EXPECT_EQ(elements, solid.elementCount());
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
}

double relative(double value, double reference) { return std::abs(value - reference) / reference; }

TEST(Lattice, OfACubeThatCellsFitIsItsCells) {
  const Lattice lattice = makeLattice(shapes::cube(), {.cellSize = 0.1});
  expectSound(lattice);
  EXPECT_EQ(lattice.solid.elementCount(), 1000);
  EXPECT_EQ(lattice.solid.nodes.size(), 1331u);
  for (const double fill : lattice.solid.fill) EXPECT_EQ(fill, 1);
  EXPECT_TRUE(findings(lattice.report).empty());
}

TEST(Lattice, FilledVolumeConvergesToTheSurfaces) {
  for (const auto& [name, mesh] : bodies::sound()) {
    const double volume = bodies::volumeOf(mesh);
    for (const auto& [cellSize, most] : {std::pair(0.2, 0.01), {0.1, 0.003}, {0.05, 0.001}}) {
      const Lattice lattice = makeLattice(mesh, {.cellSize = cellSize, .leastFill = 1e-9});
      EXPECT_LT(relative(lattice.report.filledVolume, volume), most) << name << " in cells of " << cellSize;
      EXPECT_NEAR(lattice.report.surfaceVolume, volume, 1e-12 * volume);
      EXPECT_EQ(lattice.report.crossedVolume, 0) << name;
      EXPECT_EQ(lattice.report.bodies, 1) << name;
      EXPECT_TRUE(findings(lattice.report).empty()) << name << ": " << findings(lattice.report)[0];
    }
    expectSound(makeLattice(mesh, {.cellSize = 0.1}));
  }
}

TEST(Lattice, MeetsTheWantedNumberOfElements) {
  for (const auto& [name, mesh] : bodies::sound()) {
    for (const int wanted : {500, 5000, 50000}) {
      const LatticeReport report = makeLattice(mesh, {.elements = wanted}).report;
      EXPECT_LT(relative(report.elements, wanted), 0.1) << name << ", " << wanted;
      EXPECT_LT(relative(report.filledVolume, report.surfaceVolume), 0.01) << name << ", " << wanted;
    }
    EXPECT_GE(makeLattice(mesh, {.elements = 1}).report.elements, 1) << name;
  }
}

/// The same body whatever is wrong with its surface.
TEST(Lattice, FillsAFaultySurfaceAsASoundOne) {
  const TriangleMesh sphere = shapes::sphere(48);
  const double volume = bodies::volumeOf(sphere);
  TriangleMesh doubled = sphere, slivers = sphere, sieve = sphere, mixed = sphere;
  doubled.triangles.insert(doubled.triangles.end(), sphere.triangles.begin(), sphere.triangles.begin() + 500);
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    // Fins on edges: of no area, and of next to none.
    const Eigen::Vector3i edge = sphere.triangles[random() % sphere.triangles.size()];
    const int point = static_cast<int>(slivers.points.size());
    const Vector3f middle = (sphere.points[edge[0]] + sphere.points[edge[1]]) / 2;
    slivers.points.push_back(i % 2 == 0 ? middle : middle * 1.000001f);
    slivers.triangles.emplace_back(edge[0], edge[1], point);
    slivers.triangles.emplace_back(edge[0], edge[0], point);
  }
  std::shuffle(sieve.triangles.begin(), sieve.triangles.end(), random);
  sieve.triangles.resize(sieve.triangles.size() * 93 / 100);
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 3)
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  const std::vector<bodies::Named> faulty = {{"inside out", shapes::flipped(sphere)},
                                             {"doubled", doubled},
                                             {"slivers", slivers},
                                             {"a sieve", sieve},
                                             {"an inside-out sieve", shapes::flipped(sieve)},
                                             {"mixed senses", mixed}};
  for (const auto& [name, mesh] : faulty) {
    const Lattice lattice = makeLattice(mesh, {.cellSize = 0.1});
    expectSound(lattice);
    EXPECT_LT(relative(lattice.report.filledVolume, volume), 0.01) << name;
    EXPECT_FALSE(findings(lattice.report).empty()) << name;
  }
}

TEST(Lattice, ClosesHolesByTheirPlane) {
  // A cap of height s off the unit sphere: s / 2 of its area, and pi s^2 (3 - s) / 3 of its volume.
  for (const double height : {0.1, 0.2, 1.0}) {
    const TriangleMesh open =
        bodies::placed(bodies::cut(shapes::sphere(180), {0, 0, 1}, static_cast<float>(1 - height + 1e-4)),
                       Vector3d(0.3, 0.2, 0.1), bodies::tilted());
    const double rim = std::cos(std::ceil(std::acos(1 - height + 1e-4) * 90 / std::numbers::pi - 1e-9) *
                                std::numbers::pi / 90);
    const double s = 1 - rim;
    const double volume = 4 * std::numbers::pi / 3 - std::numbers::pi * s * s * (3 - s) / 3;
    const LatticeReport report = makeLattice(open, {.cellSize = 0.08}).report;
    EXPECT_LT(relative(report.filledVolume, volume), 0.006) << height;
    EXPECT_EQ(report.openEdges, 180);
    EXPECT_EQ(report.holes, 1);
    EXPECT_THAT(findings(report), testing::Contains("180 open edges around 1 hole closed"));
  }
}

TEST(Lattice, CountsTheOverlapOfCrossingSpheresOnce) {
  const TriangleMesh sphere = shapes::sphere(96);
  const LatticeReport report =
      makeLattice(bodies::together(sphere, bodies::placed(sphere, {1, 0.01, 0.02})), {.cellSize = 0.1})
          .report;
  // Two caps of height 1 - d / 2, d the distance.
  const double d = Vector3d(1, 0.01, 0.02).norm(), s = 1 - d / 2;
  const double lens = 2 * std::numbers::pi * s * s * (3 - s) / 3;
  EXPECT_LT(relative(report.filledVolume, 8 * std::numbers::pi / 3 - lens), 0.006);
  EXPECT_LT(relative(report.crossedVolume, lens), 0.02);
  EXPECT_EQ(report.bodies, 1);
  EXPECT_THAT(findings(report), testing::Contains(HasSubstr("cross itself, in 18")));
}

TEST(Lattice, JoinsPartsThatOverlapInWholeCells) {
  const TriangleMesh cube = shapes::cube();
  const TriangleMesh overlapping = bodies::together(cube, bodies::placed(cube, {0.5, 0, 0}));
  const LatticeReport report = makeLattice(overlapping, {.cellSize = 0.25}).report;
  EXPECT_EQ(report.bodies, 1) << "no cell is cut, and none holds both surfaces";
  EXPECT_EQ(report.elements, 96);
  EXPECT_DOUBLE_EQ(report.filledVolume, 1.5);
}

TEST(LatticeGrid, FindsTheCellOfAPlaceOnItsFacesToo) {
  const LatticeGrid grid{Vector3d(1, 2, 3), 0.5, {4, 3, 2}};
  for (int number = 0; number < grid.cellCount(); ++number)
    EXPECT_EQ(grid.cellNumber(grid.cellOf(number)), number);
  const auto cellAround = [&](const Vector3d& x) { return grid.cellAround(x, [](int) { return true; }); };
  EXPECT_EQ(cellAround({2.5, 1.5, 0.5}), grid.cellNumber({2, 1, 0}));
  for (int axis = 0; axis < 3; ++axis)
    for (const double beyond : {1e-7, 1e-5}) {
      const int expected = beyond < LatticeGrid::tolerance ? 0 : -1;
      EXPECT_EQ(cellAround(-beyond * Vector3d::Unit(axis)), expected);
      const Vector3d corner = grid.cells.cast<double>() + beyond * Vector3d::Unit(axis);
      EXPECT_EQ(cellAround(corner), expected < 0 ? -1 : grid.cellCount() - 1);
    }
  const auto second = [](int number) { return number == 1; };
  EXPECT_EQ(grid.cellAround({1, 0.5, 0.5}, second), 1) << "of the two that meet there";
}

TEST(Lattice, FillsManyPartsInEachOtherAsOne) {
  constexpr int shells = 3000;
  TriangleMesh nested;
  for (int i = 1; i <= shells; ++i)
    nested = bodies::together(std::move(nested), bodies::placed(shapes::cube(), Vector3d::Constant(-0.5 * i),
                                                                i * Matrix3d::Identity()));
  const LatticeReport report = makeLattice(nested, {.cellSize = 2.0 * shells}).report;
  EXPECT_EQ(report.bodies, 1);
  EXPECT_LT(relative(report.insideVolume, std::pow(shells, 3)), 1e-9);
}

TEST(Lattice, LeavesACavityEmpty) {
  const TriangleMesh sphere = shapes::sphere(96);
  const TriangleMesh hole =
      shapes::flipped(bodies::placed(sphere, Vector3d::Zero(), 0.6 * Matrix3d::Identity()));
  const LatticeReport report = makeLattice(bodies::together(sphere, hole), {.cellSize = 0.1}).report;
  EXPECT_LT(relative(report.filledVolume, report.surfaceVolume), 0.005);
  EXPECT_EQ(report.bodies, 1);
  EXPECT_EQ(report.crossedVolume, 0);
}

TEST(Lattice, KeepsANeckThinnerThanACell) {
  // Two spheres and a rod of a fiftieth of their radius, one surface.
  const TriangleMesh dumbbell = bodies::placed(
      shapes::closedGrid(24, 400,
                         [](double u, double v) {
                           // Along the axis and back within, so that the grid closes.
                           const double t = v < 0.5 ? 4 * v - 1 : 3 - 4 * v;  // [-1, 1]
                           const double z = 3 * t;
                           const double ball = 1 - std::pow(std::abs(z) - 2, 2);
                           const double r = v < 0.5 ? std::max(std::sqrt(std::max(ball, 0.0)), 0.02) : 0.001;
                           const double a = 2 * std::numbers::pi * u;
                           return Vector3d(r * std::cos(a), r * std::sin(a), z);
                         }),
      Vector3d(0.123, 0.07, 0.2));
  const Lattice lattice = makeLattice(dumbbell, {.cellSize = 0.25});
  expectSound(lattice);
  EXPECT_EQ(lattice.report.bodies, 1);
  EXPECT_GT(lattice.report.raised, 0);
  EXPECT_LT(relative(lattice.report.filledVolume, std::abs(lattice.report.surfaceVolume)), 0.02);
}

TEST(Lattice, KeepsPartsApartThatShareNoCell) {
  const TriangleMesh cube = shapes::cube();
  const auto apart = [&](double gap) {
    return makeLattice(bodies::together(cube, bodies::placed(cube, {1 + gap, 0, 0})), {.cellSize = 0.25});
  };
  const Lattice touching = apart(0);  // face to face, in cells of their own
  expectSound(touching);
  EXPECT_EQ(touching.report.bodies, 2);
  EXPECT_EQ(touching.report.elements, 128);
  EXPECT_EQ(touching.report.nodes, 250);
  EXPECT_EQ(apart(0.125).report.bodies, 1) << "the middle cells hold both";
  EXPECT_EQ(apart(0.5).report.bodies, 2);
  EXPECT_THAT(findings(apart(0.5).report), testing::Contains("2 bodies that do not hang together"));
}

TEST(Lattice, IsTheSameFarFromTheOriginAndInAnySize) {
  const TriangleMesh body = bodies::placed(shapes::torus(60, 30), Vector3d::Zero(), bodies::tilted());
  const Lattice reference = makeLattice(body, {.elements = 3000});
  for (const auto& [scale, offset] :
       {std::pair(1e-3, 0.0), {1e3, 0.0}, {1e-20, 0.0}, {1e20, 0.0}, {1.0, 100.0}}) {
    const Lattice lattice = makeLattice(
        bodies::placed(body, Vector3d::Constant(offset), scale * Matrix3d::Identity()), {.elements = 3000});
    expectSound(lattice);
    EXPECT_LT(relative(lattice.report.elements, reference.report.elements), 0.01) << scale << " " << offset;
    EXPECT_LT(relative(lattice.report.filledVolume, lattice.report.surfaceVolume), 0.01)
        << scale << " " << offset;
  }
}

TEST(Lattice, IsTheSameEachTimeAndWhateverTheOrderOfTriangles) {
  TriangleMesh body = bodies::placed(shapes::torus(60, 30), Vector3d::Zero(), bodies::tilted());
  const Lattice first = makeLattice(body);
  const Lattice again = makeLattice(body);
  EXPECT_EQ(first.solid.fill, again.solid.fill);
  EXPECT_EQ(first.solid.elements, again.solid.elements);
  std::mt19937 random(9);
  std::shuffle(body.triangles.begin(), body.triangles.end(), random);
  const Lattice shuffled = makeLattice(body);
  EXPECT_EQ(first.solid.elements, shuffled.solid.elements);
  for (std::size_t e = 0; e < first.solid.fill.size(); ++e)
    EXPECT_NEAR(first.solid.fill[e], shuffled.solid.fill[e], 1e-12);
}

TEST(Lattice, RaisesWhatIsNextToEmpty) {
  const Lattice lattice = makeLattice(shapes::sphere(48), {.cellSize = 0.1, .leastFill = 0.05});
  EXPECT_GT(lattice.report.raised, 10);
  EXPECT_EQ(std::ranges::count(lattice.solid.fill, 0.05), lattice.report.raised);
  EXPECT_GE(std::ranges::min(lattice.solid.fill), 0.05);
  const LatticeReport coarse = makeLattice(shapes::sphere(48), {.cellSize = 100, .leastFill = 0.05}).report;
  EXPECT_EQ(coarse.elements, 1);
  EXPECT_THAT(findings(coarse), testing::Contains(HasSubstr("cells are too large for the body")));
}

std::string refusal(const TriangleMesh& mesh, const LatticeOptions& options = {}) {
  try {
    makeLattice(mesh, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Lattice, RefusesWithAPlainSentence) {
  const TriangleMesh cube = shapes::cube();
  EXPECT_EQ(refusal({}), "triangles: there are none");
  EXPECT_THAT(refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}),
              HasSubstr("no closed surface: 3 of 3"));
  EXPECT_EQ(refusal({{{1, 2, 3}}, {{0, 0, 0}}}), "triangles: the surface encloses no volume");
  const TriangleMesh flat = bodies::placed(shapes::sphere(24), {0, 0, 5}, Vector3d(1, 1, 0).asDiagonal());
  EXPECT_EQ(refusal(flat), "triangles: the surface encloses no volume");
  const TriangleMesh sheet = bodies::placed(bodies::cut(shapes::sphere(24), {0, 0, 1}, 0.1f), {0, 0, 5},
                                            bodies::tilted() * Vector3d(1, 1, 0).asDiagonal());
  EXPECT_EQ(refusal(sheet), "triangles: the surface encloses no volume");
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refusal({{{0, 0, 0}, {1, infinity, 0}}, {{0, 1, 1}}}), "points: point 1 is not finite");
  EXPECT_EQ(refusal({{{0, 0, 0}}, {{0, -1, 0}}}), "triangles: triangle 0 uses point -1 of 1");
  EXPECT_EQ(refusal(cube, {.elements = 0}), "elements: must be from 1 to 1000000, is 0");
  EXPECT_EQ(refusal(cube, {.cellSize = -1}), "cellSize: must be 0 or a length in metres");
  EXPECT_EQ(refusal(cube, {.cellSize = std::numeric_limits<double>::quiet_NaN()}),
            "cellSize: must be 0 or a length in metres");
  EXPECT_EQ(refusal(cube, {.leastFill = 0}), "leastFill: must be above 0 and at most 1");
  EXPECT_THAT(refusal(cube, {.cellSize = 1e-3}), HasSubstr("are too small: over 8388608 in the block"));
  EXPECT_THAT(refusal(cube, {.cellSize = 1e-300}), HasSubstr("are too small"));
}

}  // namespace
}  // namespace pleura
