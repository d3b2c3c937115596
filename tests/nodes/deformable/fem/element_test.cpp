#include <limits>
#include <numeric>
#include <stdexcept>

#include "solid_bodies.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/element.h>

namespace pleura {
namespace {

TEST(Element, GradientsAreThoseOfALinearField) {
  for (const int kind : {4, 8}) {
    SolidMesh mesh = cube(3, kind);
    distort(mesh, 0.05);
    const SolidElements elements = makeSolidElements(mesh);
    EXPECT_EQ(elements.count(), mesh.elementCount());
    Eigen::Matrix3d slope;
    slope << 1, 2, 3, -4, 5, -6, 0.5, 8, 9;
    double volume = 0;
    for (int e = 0; e < elements.count(); ++e)
      for (int q = e * elements.pointsPerElement; q < (e + 1) * elements.pointsPerElement; ++q) {
        Eigen::Matrix3d found = Eigen::Matrix3d::Zero();
        for (int a = 0; a < kind; ++a)
          found += slope * mesh.nodes[elements.nodesOf(e)[a]] * elements.gradientsAt(q)[a].transpose();
        EXPECT_LT((found - slope).norm(), 1e-12);
        volume += elements.weight[q];
      }
    EXPECT_NEAR(volume, 1, 1e-13);
    EXPECT_NEAR(std::accumulate(elements.nodeVolume.begin(), elements.nodeVolume.end(), 0.), 1, 1e-13);
  }
}

TEST(Element, FillScalesVolume) {
  SolidMesh mesh = cube(2, 8);
  mesh.fill.assign(8, 0.25);
  const SolidElements elements = makeSolidElements(mesh);
  EXPECT_NEAR(std::accumulate(elements.weight.begin(), elements.weight.end(), 0.), 0.25, 1e-14);
  EXPECT_NEAR(std::accumulate(elements.nodeVolume.begin(), elements.nodeVolume.end(), 0.), 0.25, 1e-14);
}

TEST(Element, DegenerateOnesAreLeftOutAndCounted) {
  for (const int kind : {4, 8}) {
    SolidMesh mesh = cube(2, kind);
    const int whole = mesh.elementCount();
    const std::vector<int> first(mesh.elements.begin(), mesh.elements.begin() + kind);
    std::vector<int> insideOut = first;  // mirrored: the first two corners, or those of each edge along x
    for (int a = 0; a < (kind == 4 ? 2 : 8); a += 2) std::swap(insideOut[a], insideOut[a + 1]);
    const std::vector<int> flat(first.size(), first[0]);
    for (const auto& bad : {insideOut, flat})
      mesh.elements.insert(mesh.elements.end(), bad.begin(), bad.end());
    const SolidElements elements = makeSolidElements(mesh);
    EXPECT_EQ(elements.degenerateCount, 2);
    EXPECT_EQ(elements.count(), whole);
  }
}

TEST(Element, FlatOnesStayToABillionth) {
  for (const int kind : {4, 8}) {
    SolidMesh mesh = cube(2, kind);
    for (auto& x : mesh.nodes) x.z() *= 1e-7;
    EXPECT_EQ(makeSolidElements(mesh).degenerateCount, 0);
    for (auto& x : mesh.nodes) x.z() *= 1e-3;
    EXPECT_THROW(makeSolidElements(mesh), std::invalid_argument);
  }
}

TEST(Element, BadMeshesAndMaterialsAreRefused) {
  const auto refuses = [](auto change) {
    SolidMesh mesh = cube(1, 4);
    change(mesh);
    EXPECT_THROW(makeSolidElements(mesh), std::invalid_argument);
  };
  refuses([](SolidMesh& mesh) { mesh = {}; });
  refuses([](SolidMesh& mesh) { mesh.elements.pop_back(); });
  refuses([](SolidMesh& mesh) {
    mesh.elements.resize(4 * (kMostElements + 1));
    for (std::size_t k = 4; k < mesh.elements.size(); ++k) mesh.elements[k] = mesh.elements[k - 4];
  });
  refuses([](SolidMesh& mesh) { mesh.elements[3] = 8; });
  refuses([](SolidMesh& mesh) { mesh.elements[3] = -1; });
  refuses([](SolidMesh& mesh) { mesh.nodesPerElement = 5; });
  refuses([](SolidMesh& mesh) { mesh.nodes[2].y() = std::numeric_limits<double>::quiet_NaN(); });
  refuses([](SolidMesh& mesh) { mesh.nodes[2].y() = std::numeric_limits<double>::infinity(); });
  refuses([](SolidMesh& mesh) { mesh.fill = {1, 1}; });
  refuses([](SolidMesh& mesh) { mesh.fill = {1, 1, 1, 1, 0}; });
  refuses([](SolidMesh& mesh) {
    for (auto& x : mesh.nodes) x.z() = 0;
  });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const SolidMaterial& bad : std::initializer_list<SolidMaterial>{{.density = -1},
                                                                       {.density = 0},
                                                                       {.youngsModulus = 0},
                                                                       {.youngsModulus = nan},
                                                                       {.poissonRatio = 0.5},
                                                                       {.poissonRatio = -0.1},
                                                                       {.massDamping = -1},
                                                                       {.stiffnessDamping = nan}})
    EXPECT_THROW(lameOf(bad), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
