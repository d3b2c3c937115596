#pragma once

#include <string>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>
#include <pleura/x3d/browser/anatomy/node_maker.h>
#include <pleura/x3d/encoding/document.h>

namespace pleura {

/// A scene file: its name in the anatomy's folder, and its text.
struct SceneFile {
  std::string name;
  std::string text;
};

/// The document as `name`.x3d: `what` it holds, `source` of the shapes.
SceneFile sceneFile(Document& document, const std::string& name, const std::string& what,
                    const std::string& source);

/// The mesh as an IndexedTriangleSet with a Coordinate of name `def`, coordinates rounded to 1 / `perUnit`.
NodePtr triangleSet(const NodeMaker& maker, const TriangleMesh& mesh, bool isSolid, float perUnit,
                    const std::string& def = {});

/// `p` rounded to 1 / `perUnit`.
inline Vec3f rounded(const Vec3f& p, float perUnit) {
  return (p * perUnit).array().round().matrix() / perUnit;
}

}  // namespace pleura
