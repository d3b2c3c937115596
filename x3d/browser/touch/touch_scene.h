#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include <pleura/haptics/servo/touch_frame.h>
#include <pleura/nodes/haptic/force_effect_node.h>
#include <pleura/nodes/haptic/haptic_surface_node.h>
#include <pleura/nodes/standard/shape/touchable_shape.h>
#include <pleura/nodes/standard/shape/x3d_shape_node.h>
#include <pleura/x3d/browser/scene/scene.h>

namespace pleura {

/// What there is to feel of a scene, as the haptic loop takes it. Pulls what has a surface and is displayed,
/// and nothing else: a scene in which nothing can be touched builds no tree. Lives as long as the scene.
class TouchScene {
 public:
  explicit TouchScene(Scene& scene) : scene_(scene) {}

  /// What a shape, or the nearest group around it, is called.
  struct Called {
    std::string name;   // its DEF name
    std::string title;  // from its metadata, or its DEF name

    bool operator==(const Called&) const = default;
  };

  /// A shape where it stands in the scene.
  struct Part {
    NodePtr keepAlive;
    X3DShapeNode* shape = nullptr;
    X3DGeometryNode* geometry = nullptr;
    HapticSurfaceNode* surface = nullptr;
    Called called;
    Matrix4f toWorld = Matrix4f::Identity();

    /// Whether it is seen to be pressed in where it is touched.
    bool givesWay() const { return surface->givesWay() && dynamic_cast<TouchableShape*>(shape) != nullptr; }
  };

  struct Effect {
    NodePtr keepAlive;
    ForceEffectNode* node = nullptr;
    haptics::ForceEffect force;
  };

  /// Looks at the scene as it is now.
  void update();

  /// parts()[id], as long as the scene's structure stays; those that are gone have no geometry.
  const std::vector<Part>& parts() const { return parts_; }
  const std::vector<Effect>& effects() const { return effects_; }

  /// The frame that the bound viewpoint stands in.
  const Matrix4f& viewpointToWorld() const { return viewpointToWorld_; }

  /// Writes shapes and effects into a frame that may have served before; trees are refitted only where points
  /// have moved since. `stiffness` [N/m] and `damping` [N s/m] are what the device can render.
  void fill(haptics::TouchFrame& frame, double stiffness, double damping);

  /// Trees built and refitted so far.
  std::uint64_t builds() const { return builds_; }
  std::uint64_t refits() const { return refits_; }

 private:
  /// The points of a shape [m] in the frame that it moves in rigidly: any stretch of its transform is in
  /// them.
  struct Surface {
    std::shared_ptr<const haptics::TouchMesh> mesh;
    std::vector<Vec3f> points;
    std::uint64_t stamp = 0;  // of the points
    std::array<std::uint64_t, 2> source{};
    std::size_t triangleCount = 0;
    Matrix4f toWorld = Matrix4f::Identity();  // of which pose and stretch are the parts
    Eigen::Matrix3f stretch = Eigen::Matrix3f::Identity();
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    bool isTwoSided = false;
    bool isSound = false;
  };

  void visit(const NodePtr& node, const Matrix4f& toWorld, const Called& around);
  void addPart(const NodePtr& node, X3DShapeNode& shape, const Matrix4f& toWorld, const Called& called);
  void addEffect(const NodePtr& node, ForceEffectNode& effect, const Matrix4f& toWorld);
  void updateSurface(const Part& part, Surface& surface);
  void build(const Part& part, Surface& surface, std::span<const Vec3f> points,
             std::span<const Eigen::Vector3i> triangles);

  Scene& scene_;
  std::vector<Part> parts_;
  std::vector<Surface> surfaces_;  // of parts_
  std::vector<Effect> effects_;
  Matrix4f viewpointToWorld_ = Matrix4f::Identity();
  std::unordered_map<const Node*, std::vector<std::uint32_t>> idsOf_;  // of a shape, one a place
  std::unordered_map<const Node*, std::size_t> placesSeen_;            // in this update
  std::unordered_map<const Node*, std::uint32_t> effectIds_;
  std::vector<Eigen::Vector3i> triangles_;  // working space
  std::vector<Vec3f> moved_;                // the same
  std::uint64_t nextStamp_ = 1;
  std::uint64_t builds_ = 0;
  std::uint64_t refits_ = 0;
};

}  // namespace pleura
