#pragma once

#include <span>
#include <vector>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/deformable/contact/dent.h>
#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// How an organ answers when some of its points are moved: rest shape and driven points in, all positions
/// out. A deformer serves one shape.
class DeformerNode : public Node {
 public:
  /// The shape at rest and the points that keep their places to one another. Called when either changes; may
  /// allocate. Throws std::invalid_argument for a shape that it can't take.
  virtual void setRest(const TriangleMesh& rest, std::span<const int> rigidPoints) = 0;

  /// Moves point driven[i] to targets[i] [m] and the others as they follow, into `positions`, one a rest
  /// point. Has no memory: the same inputs give the same bits. Does not allocate. Throws
  /// std::invalid_argument, `positions` untouched, for targets that are not finite.
  virtual void deform(std::span<const int> driven, std::span<const Vec3f> targets,
                      std::span<Vec3f> positions) = 0;

  /// Presses a dent into the shape that deform() made: what gives way to touch, locally. Does not allocate.
  virtual void give(const Dent& dent, std::span<const Eigen::Vector3i> triangles,
                    std::span<Vec3f> positions) {
    press(dent, triangles, positions);
  }

  /// Fields beside the driven points that the shape depends on.
  virtual std::vector<Field*> inputs() { return {}; }

  static void declare(NodeType& type) {
    Node::declare(type);
    type.containedIn("deformer");
  }
};

}  // namespace pleura
