#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include <pleura/nodes/standard/geometry3d/box.h>
#include <pleura/nodes/standard/geometry3d/cone.h>
#include <pleura/nodes/standard/geometry3d/cylinder.h>
#include <pleura/nodes/standard/geometry3d/indexed_face_set.h>
#include <pleura/nodes/standard/geometry3d/sphere.h>
#include <pleura/nodes/standard/rendering/color.h>
#include <pleura/nodes/standard/rendering/coordinate.h>
#include <pleura/nodes/standard/rendering/coordinate_double.h>
#include <pleura/nodes/standard/rendering/indexed_line_set.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_fan_set.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_set.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_strip_set.h>
#include <pleura/nodes/standard/rendering/line_set.h>
#include <pleura/nodes/standard/rendering/normal.h>
#include <pleura/nodes/standard/rendering/point_set.h>
#include <pleura/nodes/standard/rendering/triangle_set.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

constexpr double kPi = std::numbers::pi;

std::shared_ptr<Coordinate> points(std::vector<Vec3f> values) {
  auto node = create<Coordinate>();
  node->point.setValue(std::move(values));
  return node;
}

Vec3d corner(const RenderMesh& mesh, std::size_t index) {
  return mesh.positions[mesh.indices[index]].cast<double>();
}

double area(const RenderMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    sum += (corner(mesh, i + 1) - corner(mesh, i)).cross(corner(mesh, i + 2) - corner(mesh, i)).norm() / 2;
  return sum;
}

double volume(const RenderMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    sum += corner(mesh, i).dot(corner(mesh, i + 1).cross(corner(mesh, i + 2))) / 6;
  return sum;
}

void expectNormalsOutwards(const RenderMesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3d n = (corner(mesh, i + 1) - corner(mesh, i)).cross(corner(mesh, i + 2) - corner(mesh, i));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3f& normal = mesh.normals[mesh.indices[i + k]];
      EXPECT_NEAR(normal.norm(), 1, 1e-5);
      EXPECT_GT(n.normalized().dot(normal.cast<double>()), 0.8);
    }
  }
}

TEST(Primitives, EncloseTheirVolume) {
  TestContext context;
  const auto box = context.make<Box>([](Box& b) { b.size.setValue({1, 2, 3}); });
  const auto sphere = context.make<Sphere>([](Sphere& s) { s.radius.setValue(2); });
  const auto cylinder = context.make<Cylinder>([](Cylinder& c) { c.height.setValue(3); });
  const auto cone = context.make<Cone>([](Cone& c) { c.bottomRadius.setValue(0.5); });
  EXPECT_NEAR(volume(box->renderMesh()), 6, 1e-5);
  EXPECT_NEAR(volume(sphere->renderMesh()) / (4.0 / 3 * kPi * 8), 1, 0.03);
  EXPECT_NEAR(volume(cylinder->renderMesh()) / (kPi * 3), 1, 0.01);
  EXPECT_NEAR(volume(cone->renderMesh()) / (kPi * 0.25 * 2 / 3), 1, 0.01);
  for (X3DGeometryNode* node :
       std::initializer_list<X3DGeometryNode*>{box.get(), sphere.get(), cylinder.get(), cone.get()})
    expectNormalsOutwards(node->renderMesh());
}

TEST(Primitives, LeaveOutWhatIsSwitchedOff) {
  TestContext context;
  const auto cylinder = context.make<Cylinder>();
  const double whole = area(cylinder->renderMesh());
  cylinder->top.setValue(false);
  EXPECT_NEAR(whole - area(cylinder->renderMesh()), kPi, 0.05);
  cylinder->bottom.setValue(false);
  cylinder->side.setValue(false);
  EXPECT_TRUE(cylinder->renderMesh().indices.empty());
}

TEST(Primitives, AreBuiltOnce) {
  TestContext context;
  const auto sphere = context.make<Sphere>();
  const auto revision = sphere->renderMesh().topologyRevision;
  EXPECT_EQ(sphere->renderMesh().topologyRevision, revision);
}

/// A unit cube as six quads over eight points.
const std::vector<Vec3f> kCube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<std::int32_t> kCubeFaces = {0, 3, 2, 1, -1, 4, 5, 6, 7, -1, 0, 1, 5, 4, -1,
                                              1, 2, 6, 5, -1, 2, 3, 7, 6, -1, 3, 0, 4, 7};

class FaceSet : public ::testing::Test {
 protected:
  std::shared_ptr<IndexedFaceSet> make(std::vector<Vec3f> at, std::vector<std::int32_t> index,
                                       float crease = 0, bool convex = true) {
    return context.make<IndexedFaceSet>([&](IndexedFaceSet& faces) {
      faces.coord.setValue(points(std::move(at)));
      faces.coordIndex.setValue(std::move(index));
      faces.creaseAngle.setValue(crease);
      faces.convex.setValue(convex);
    });
  }
  TestContext context;
};

TEST_F(FaceSet, KeepsEdgesThatMeetAtTheCreaseAngle) {
  const auto sharp = make(kCube, kCubeFaces, 1.5f);
  EXPECT_EQ(sharp->renderMesh().positions.size(), 24u);
  const auto smooth = make(kCube, kCubeFaces, 1.6f);
  EXPECT_EQ(smooth->renderMesh().positions.size(), 8u);
  for (const auto* node : {&sharp, &smooth}) {
    EXPECT_NEAR(volume((*node)->renderMesh()), 1, 1e-6);
    EXPECT_NEAR(area((*node)->renderMesh()), 6, 1e-6);
  }
  const auto flat = make(kCube, kCubeFaces);
  expectNormalsOutwards(flat->renderMesh());
}

TEST_F(FaceSet, SmoothsOneEdgeAndNotTheNext) {
  // Two sides of a roof at 60 degrees to one another, and a wall at a right angle to one of them.
  const float s = std::sqrt(3.0f) / 2;
  const auto node =
      make({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {1.5f, -s, 1}, {1.5f, -s, 0}, {0, -1, 0}, {0, -1, 1}},
           {0, 1, 2, 3, -1, 3, 2, 4, 5, -1, 1, 0, 6, 7}, 1.2f);
  EXPECT_EQ(node->renderMesh().positions.size(), 10u) << "2 split points, 6 that are not";
}

TEST_F(FaceSet, TurnsNormalsOfClockwiseFaces) {
  const auto node = context.make<IndexedFaceSet>([](IndexedFaceSet& faces) {
    faces.coord.setValue(points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    faces.coordIndex.setValue({0, 1, 2});
    faces.ccw.setValue(false);
  });
  EXPECT_FALSE(node->renderMesh().ccw);
  EXPECT_EQ(node->renderMesh().normals[0], Vec3f(0, 0, -1));
}

/// A star of `tips` tips: concave at every second point, of known area.
std::vector<Vec3f> star(int tips, double inner) {
  std::vector<Vec3f> at;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = kPi * i / tips;
    const double r = i % 2 == 0 ? 1 : inner;
    at.emplace_back(0.2f, static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)));
  }
  return at;
}

TEST_F(FaceSet, CutsConcaveFacesWithoutOverlap) {
  for (const int tips : {3, 5, 17, 100}) {
    std::vector<std::int32_t> index;
    for (int i = 0; i < 2 * tips; ++i) index.push_back(i);
    const auto node = make(star(tips, 0.2), index, 0, false);
    const RenderMesh& mesh = node->renderMesh();
    EXPECT_EQ(mesh.indices.size(), 3u * (2 * static_cast<std::size_t>(tips) - 2));
    EXPECT_NEAR(area(mesh), tips * 0.2 * std::sin(kPi / tips), 1e-5) << tips;
    expectNormalsOutwards(mesh);
  }
}

TEST_F(FaceSet, LeavesOutFacesWithoutPointsAndWarnsOnce) {
  const auto node = make(kCube, {0, 1, 2, -1, 0, 1, 8, -1, 0, 99, 1, -1, 0, 1, -1, -1, 4, 5, 6});
  EXPECT_EQ(node->renderMesh().indices.size(), 6u);
  ASSERT_EQ(context.warnings.size(), 1u);
  EXPECT_NE(context.warnings[0].find("2 parts"), std::string::npos) << context.warnings[0];
  node->set_coordIndex.setValue({0, 1, 50});
  EXPECT_TRUE(node->renderMesh().indices.empty());
  EXPECT_EQ(context.warnings.size(), 1u);
}

TEST_F(FaceSet, TakesColoursPerVertexPerFaceAndByIndex) {
  const auto colors = create<Color>();
  colors->color.setValue({RGB(1, 0, 0), RGB(0, 1, 0), RGB(0, 0, 1)});
  const auto make2 = [&](bool perVertex, std::vector<std::int32_t> index) {
    return context.make<IndexedFaceSet>([&](IndexedFaceSet& faces) {
      faces.coord.setValue(points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
      faces.coordIndex.setValue({0, 1, 2, -1, 2, 1, 3, -1});
      faces.color.setValue(colors);
      faces.colorPerVertex.setValue(perVertex);
      faces.colorIndex.setValue(index);
      faces.creaseAngle.setValue(4);
    });
  };
  const auto colorAt = [](IndexedFaceSet& node, std::size_t i) {
    const RenderMesh& mesh = node.renderMesh();
    return mesh.colors.at(mesh.indices.at(i));
  };
  const RGBA red(1, 0, 0, 1), green(0, 1, 0, 1), blue(0, 0, 1, 1);
  const auto perFace = make2(false, {});
  EXPECT_EQ(colorAt(*perFace, 2), red);
  EXPECT_EQ(colorAt(*perFace, 3), green);
  const auto perFaceByIndex = make2(false, {2, 0});
  EXPECT_EQ(colorAt(*perFaceByIndex, 0), blue);
  EXPECT_EQ(colorAt(*perFaceByIndex, 5), red);
  const auto byIndex = make2(true, {0, 1, 2, -1, 2, 1, 0, -1});
  EXPECT_EQ(colorAt(*byIndex, 1), green);
  EXPECT_EQ(colorAt(*byIndex, 5), red);
  EXPECT_TRUE(context.warnings.empty());
  const auto tooFew = make2(true, {});
  EXPECT_TRUE(tooFew->renderMesh().colors.empty()) << "point 3 has no colour";
  EXPECT_EQ(context.warnings.size(), 1u);
}

std::shared_ptr<IndexedTriangleSet> grid(TestContext& context, int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> height(0, 0.3f);
  std::vector<Vec3f> at;
  std::vector<std::int32_t> index;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      at.emplace_back(static_cast<float>(k), static_cast<float>(i), height(random));
      const int p = i * n + k;
      if (i + 1 < n && k + 1 < n) index.insert(index.end(), {p, p + 1, p + n, p + n, p + 1, p + n + 1});
    }
  return context.make<IndexedTriangleSet>([&](IndexedTriangleSet& set) {
    set.coord.setValue(points(at));
    set.index.setValue(index);
  });
}

TEST(TriangleSets, RenewOnlyVerticesWhenPointsMove) {
  TestContext context;
  const auto node = grid(context, 20, 1);
  auto& coordinate = static_cast<Coordinate&>(*node->coord.getValue());
  const RenderMesh& mesh = node->renderMesh();
  EXPECT_EQ(mesh.positions.size(), 400u) << "smooth: a vertex for each point";
  const auto* data = mesh.positions.data();
  const auto* normals = mesh.normals.data();
  const auto topology = mesh.topologyRevision;
  auto vertices = mesh.vertexRevision;
  node->renderMesh();
  EXPECT_EQ(mesh.vertexRevision, vertices) << "nothing changed";
  for (int i = 0; i < 3; ++i) {
    coordinate.point.edit([](auto& all) { all[21].z() += 5; });
    node->renderMesh();
    EXPECT_EQ(mesh.vertexRevision, ++vertices);
  }
  EXPECT_EQ(mesh.topologyRevision, topology);
  EXPECT_EQ(mesh.positions.data(), data) << "not allocated anew";
  EXPECT_EQ(mesh.normals.data(), normals);
  EXPECT_FLOAT_EQ(mesh.positions[21].z(), coordinate.point.getValue()[21].z());
  coordinate.point.setValue({});
  EXPECT_TRUE(node->renderMesh().indices.empty());
  EXPECT_GT(mesh.topologyRevision, topology);
}

TEST(TriangleSets, ComputeNormalsWeightedByArea) {
  TestContext context;
  const auto node = grid(context, 12, 2);
  const RenderMesh& mesh = node->renderMesh();
  std::vector<Vec3d> sums(mesh.positions.size(), Vec3d::Zero());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3d n = (corner(mesh, i + 1) - corner(mesh, i)).cross(corner(mesh, i + 2) - corner(mesh, i));
    for (std::size_t k = 0; k < 3; ++k) sums[mesh.indices[i + k]] += n;
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    EXPECT_LT((sums[i].normalized() - mesh.normals[i].cast<double>()).norm(), 1e-6);
}

TEST(TriangleSets, StripsAndFansTurnAlike) {
  TestContext context;
  const auto at = points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}});
  const auto strip = context.make<IndexedTriangleStripSet>([&](auto& set) {
    set.coord.setValue(at);
    set.index.setValue({0, 1, 2, 3, -1, 2, 3, 4, 5, -1});
  });
  const auto fan = context.make<IndexedTriangleFanSet>([&](auto& set) {
    set.coord.setValue(at);
    set.index.setValue({0, 1, 3, 2, -1, 2, 3, 5, 4});
  });
  const auto soup = context.make<TriangleSet>([&](auto& set) { set.coord.setValue(at); });
  EXPECT_NEAR(area(strip->renderMesh()), 2, 1e-6);
  EXPECT_NEAR(area(fan->renderMesh()), 2, 1e-6);
  EXPECT_EQ(soup->renderMesh().indices.size(), 6u);
  for (X3DGeometryNode* node : std::initializer_list<X3DGeometryNode*>{strip.get(), fan.get()})
    for (const Vec3f& normal : node->renderMesh().normals) EXPECT_EQ(normal, Vec3f(0, 0, 1));
}

TEST(TriangleSets, UseGivenNormals) {
  TestContext context;
  const auto normals = create<Normal>();
  normals->vector.setValue({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const auto node = context.make<IndexedTriangleSet>([&](IndexedTriangleSet& set) {
    set.coord.setValue(points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    set.index.setValue({0, 1, 2});
    set.normal.setValue(normals);
  });
  EXPECT_EQ(node->renderMesh().normals, normals->vector.getValue());
  normals->vector.setValue({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  EXPECT_EQ(node->renderMesh().normals, normals->vector.getValue());
  normals->vector.setValue({});
  EXPECT_EQ(node->renderMesh().normals[0], Vec3f(0, 0, 1)) << "computed";
}

TEST(TriangleSets, TakePointsInDoublePrecision) {
  TestContext context;
  const auto at = create<CoordinateDouble>();
  at->point.setValue({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const auto node = context.make<TriangleSet>([&](TriangleSet& set) { set.coord.setValue(at); });
  EXPECT_NEAR(area(node->renderMesh()), 0.5, 1e-6);
  at->point.setValue({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
  EXPECT_NEAR(area(node->renderMesh()), 2, 1e-6);
}

TEST(TriangleSets, BearAnything) {
  TestContext context;
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int32_t> number(-2, 12);
  const auto node = context.make<IndexedFaceSet>([](IndexedFaceSet& faces) {
    std::vector<Vec3f> at = kCube;
    at.push_back(at[0]);
    at.emplace_back(1e30f, -1e30f, 1e30f);
    faces.coord.setValue(points(at));
    faces.convex.setValue(false);
    faces.creaseAngle.setValue(1);
  });
  for (int i = 0; i < 200; ++i) {
    std::vector<std::int32_t> index(static_cast<std::size_t>(random() % 40));
    for (auto& each : index) each = number(random);
    node->set_coordIndex.setValue(index);
    const RenderMesh& mesh = node->renderMesh();
    for (const auto each : mesh.indices) ASSERT_LT(each, mesh.positions.size());
    for (const auto& normal : mesh.normals) ASSERT_NEAR(normal.norm(), 1, 1e-5);
  }
}

TEST(Lines, JoinTheirPointsAndTakeColours) {
  TestContext context;
  const auto at = points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  const auto indexed = context.make<IndexedLineSet>([&](IndexedLineSet& lines) {
    lines.coord.setValue(at);
    lines.coordIndex.setValue({0, 1, 2, -1, 3, 0});
  });
  EXPECT_EQ(indexed->renderMesh().primitive, RenderMesh::Primitive::lines);
  EXPECT_EQ(indexed->renderMesh().indices, (std::vector<std::uint32_t>{0, 1, 1, 2, 3, 0}));
  EXPECT_TRUE(indexed->renderMesh().normals.empty());
  const auto lines = context.make<LineSet>([&](LineSet& set) {
    set.coord.setValue(at);
    set.vertexCount.setValue({2, 2});
  });
  EXPECT_EQ(lines->renderMesh().indices, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_TRUE(context.warnings.empty());
  lines->vertexCount.setValue({4, 2000000000});
  EXPECT_EQ(lines->renderMesh().indices.size(), 6u);
  EXPECT_EQ(context.warnings.size(), 1u);
}

TEST(Points, AreOneIndexEach) {
  TestContext context;
  const auto node = context.make<PointSet>([](PointSet& set) { set.coord.setValue(points(kCube)); });
  EXPECT_EQ(node->renderMesh().primitive, RenderMesh::Primitive::points);
  EXPECT_EQ(node->renderMesh().positions, kCube);
  EXPECT_EQ(node->renderMesh().indices.size(), kCube.size());
}

}  // namespace
}  // namespace pleura
