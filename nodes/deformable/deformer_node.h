#pragma once

#include <span>
#include <vector>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/deformable/contact/dent.h>
#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// How an organ answers when some of its points are moved: rest shape and driven points in, all positions
/// out. Has no memory, unless it says so: the same inputs give the same bits. A deformer serves one shape.
class DeformerNode : public Node {
 public:
  /// Whether it serves that shape: the first that asks, until it is released.
  bool serves(const Node& shape) {
    if (served_ == nullptr) served_ = &shape;
    return served_ == &shape;
  }
  void release(const Node& shape) {
    if (served_ == &shape) served_ = nullptr;
  }

  /// The shape at rest and the points that keep their places to one another. Called when either changes; may
  /// allocate. Throws std::invalid_argument for a shape that it can't take.
  virtual void setRest(const TriangleMesh& rest, std::span<const int> rigidPoints) = 0;

  /// Takes what the next solve() needs from fields. Does not allocate while nothing but values changes.
  /// Throws std::invalid_argument for values that it can't take.
  virtual void prepare(std::span<const int> /*driven*/) {}

  /// Moves point driven[i] to targets[i] [m] and the others as they follow, into `positions`, one a rest
  /// point. On any thread, between prepare() and report(): touches no field, and nothing of the scene. Does
  /// not allocate. Throws std::invalid_argument, `positions` untouched, for targets that are not finite.
  virtual void solve(std::span<const int> driven, std::span<const Vec3f> targets,
                     std::span<Vec3f> positions) = 0;

  /// Tells by fields and warnings how a solve went that has not thrown.
  virtual void report() {}

  /// The three at once.
  void deform(std::span<const int> driven, std::span<const Vec3f> targets, std::span<Vec3f> positions) {
    prepare(driven);
    solve(driven, targets, positions);
    report();
  }

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

 private:
  const Node* served_ = nullptr;
};

}  // namespace pleura
