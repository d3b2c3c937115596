#include <fstream>
#include <random>

#include "mesh_files.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/mesh_report.h>
#include <pleura/x3d/import/mesh_import.h>

namespace pleura {
namespace {

using testing::HasSubstr;

std::string reasonFor(const std::string& content, const std::string& name) {
  try {
    importMesh(std::as_bytes(std::span(content)), name);
  } catch (const MeshImportError& error) {
    return error.what();
  }
  return "imported";
}

ImportedScene importText(const std::string& content, const std::string& name,
                         const MeshImportOptions& options = {}) {
  return importMesh(std::as_bytes(std::span(content)), name, options);
}

const std::string triangle = "v 1 2 3\nv 4 2 3\nv 1 6 3\nf 1 2 3\n";

TEST(ImportMesh, ReadsAnObjFileWithNamesAndColours) {
  const files::Folder folder;
  folder.write("two.mtl", "newmtl bone\nKd 0.9 0.8 0.7\nd 0.5\n");
  const auto path = folder.write("two.obj", "mtllib two.mtl\no rib\nusemtl bone\n" + triangle +
                                                "o lung\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 4 5 6 7\n");
  const ImportedScene scene = importMesh(path);
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(scene.parts[0].name, "rib");
  EXPECT_EQ(scene.parts[0].colour, Eigen::Vector4f(0.9f, 0.8f, 0.7f, 0.5f));
  EXPECT_EQ(scene.parts[0].mesh.points[1], Eigen::Vector3f(4, 2, 3));
  EXPECT_EQ(scene.parts[1].name, "lung");
  EXPECT_EQ(scene.parts[1].mesh.triangles.size(), 2u);
  EXPECT_EQ(scene.parts[1].mesh.points.size(), 4u);
  EXPECT_EQ(scene.diagnostics[0], "rib: 3 boundary edges around 1 hole (3)");
}

TEST(ImportMesh, MapsAxesAndScales) {
  const ImportedScene scene = importText(triangle, "a.obj", {.scale = 0.001, .axes = axesNamed("x z -y")});
  EXPECT_EQ(scene.parts[0].mesh.points[0], Eigen::Vector3f(0.001f, 0.003f, -0.002f));
}

TEST(ImportMesh, TurnsTrianglesAroundInAMirroringFrame) {
  const std::string cube = files::asObj(files::cube());
  for (const char* axes : {"x y z", "-x y z", "y x z", "z -y x"}) {
    const TriangleMesh mesh =
        importText(cube, "cube.obj", {.scale = 2, .axes = axesNamed(axes)}).parts[0].mesh;
    EXPECT_NEAR(signedVolume(mesh.points, mesh.triangles), 8, 1e-6) << axes;
  }
}

TEST(ImportMesh, KeepsASurfaceThroughEveryFormat) {
  const TriangleMesh mesh = files::bumpySphere();
  const MeshReport before = analyze(mesh);
  const files::Folder folder;
  for (const char* format : {"obj", "ply", "plyb", "stl", "stlb", "glb2", "gltf2"}) {
    SCOPED_TRACE(format);
    const ImportedScene scene = importMesh(files::exported(mesh, format, folder));
    ASSERT_EQ(scene.parts.size(), 1u);
    const MeshReport after = analyze(scene.parts[0].mesh);
    EXPECT_EQ(after.points, before.points);
    EXPECT_EQ(after.triangles, before.triangles);
    EXPECT_TRUE(after.isClosed);
    EXPECT_NEAR(after.volume, before.volume, 1e-5 * before.volume);
    EXPECT_TRUE(scene.diagnostics.empty());
  }
}

TEST(ImportMesh, PlacesPartsWhereTheNodesPutThem) {
  const files::Folder folder;
  const auto path = files::exportedAt(files::cube(), {10, 20, 30}, "glb2", folder);
  const auto box = boundingBox(importMesh(path).parts.at(0).mesh.points);
  EXPECT_EQ(box.min(), Eigen::Vector3f(10, 20, 30));
}

TEST(ImportMesh, SaysWhyAFileCannotBeUsed) {
  const files::Folder folder;
  const auto reason = [](const std::filesystem::path& path) -> std::string {
    try {
      importMesh(path);
    } catch (const MeshImportError& error) {
      return error.what();
    }
    return "imported";
  };
  EXPECT_THAT(reason(folder.path() / "none.obj"), HasSubstr("none.obj: no such file"));
  EXPECT_THAT(reason(folder.path()), HasSubstr("not a file"));
  EXPECT_THAT(reason(folder.write("empty.stl", "")), HasSubstr("empty"));
  EXPECT_THAT(reason(folder.write("mesh", triangle)), HasSubstr("no extension"));
  EXPECT_THAT(reason(folder.write("mesh.xyzzy", triangle)), HasSubstr("no reader for .xyzzy"));
}

TEST(ImportMesh, SaysWhyItsContentCannotBeUsed) {
  EXPECT_THAT(reasonFor("", "a.obj"), HasSubstr("a.obj: empty"));
  EXPECT_THAT(reasonFor("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj"), HasSubstr("a.obj: "));
  EXPECT_THAT(reasonFor("v 0 0 0\nv 1 0 0\nl 1 2\n", "a.obj"), HasSubstr("no triangles"));
  EXPECT_THAT(reasonFor("v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj"), HasSubstr("not finite"));
  EXPECT_THAT(reasonFor("v 0 inf 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj"), HasSubstr("not finite"));
  EXPECT_THAT(reasonFor("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "a.obj"), HasSubstr("a.obj: "));
  EXPECT_THAT(reasonFor("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999\n", "a.obj"), HasSubstr("a.obj: "));
  EXPECT_THAT(reasonFor("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n", "a.obj"), HasSubstr("a.obj: "));
  for (const char* name : {"a.obj", "a.stl", "a.ply", "a.gltf", "a.glb"})
    EXPECT_THAT(reasonFor("not a mesh at all, just words\n", name), HasSubstr(std::string(name) + ": "))
        << name;
}

TEST(ImportMesh, RefusesBadOptions) {
  EXPECT_THROW(importText(triangle, "a.obj", {.scale = 0}), std::invalid_argument);
  EXPECT_THROW(importText(triangle, "a.obj", {.scale = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(importText(triangle, "a.obj", {.axes = Eigen::Matrix3d::Zero()}), std::invalid_argument);
  for (const char* axes : {"", "x y", "x y y", "x y z z", "x y w", "x yy z", "- y z"})
    EXPECT_THROW(axesNamed(axes), std::invalid_argument) << axes;
  EXPECT_EQ(axesNamed("x,z,-y") * Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 3, -2));
}

/// Either a part that holds what importMesh promises, or a MeshImportError; never anything else.
void expectSoundOrRefused(const std::string& content, const std::string& name) {
  try {
    for (const ImportedPart& part : importText(content, name).parts) {
      const MeshReport report = analyze(part.mesh);
      EXPECT_EQ(report.nonFinitePoints + report.outOfRangeTriangles + report.duplicatePoints, 0) << name;
      EXPECT_GT(report.triangles, 0) << name;
    }
  } catch (const MeshImportError& error) {
    EXPECT_THAT(error.what(), HasSubstr(name));
  }
}

TEST(ImportMesh, BearsTruncatedFiles) {
  const files::Folder folder;
  for (const char* format : {"obj", "ply", "plyb", "stl", "stlb", "glb2"}) {
    const auto path = files::exported(files::cube(), format, folder);
    const std::string whole = files::read(path);
    for (std::size_t size = 1; size < whole.size(); size += 1 + whole.size() / 60)
      expectSoundOrRefused(whole.substr(0, size), path.filename().string());
  }
}

TEST(ImportMesh, BearsRubbish) {
  std::mt19937 random(1);
  const files::Folder folder;
  for (const char* format : {"obj", "ply", "plyb", "stl", "stlb"}) {
    const auto path = files::exported(files::cube(), format, folder);
    const std::string whole = files::read(path);
    for (int round = 0; round < 60; ++round) {
      std::string content = whole;
      for (int i = 0; i < 1 + round / 4; ++i)
        content[random() % content.size()] = static_cast<char>(random() % 256);
      expectSoundOrRefused(content, path.filename().string());
    }
  }
  for (const char* name : {"a.obj", "a.stl", "a.ply", "a.gltf", "a.glb"}) {
    for (int round = 0; round < 30; ++round) {
      std::string content(random() % 2000 + 1, '\0');
      for (char& byte : content) byte = static_cast<char>(random() % 256);
      expectSoundOrRefused(content, name);
    }
  }
}

}  // namespace
}  // namespace pleura
