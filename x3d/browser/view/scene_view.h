#pragma once

#include <optional>
#include <unordered_map>

#include <Eigen/Geometry>

#include <pleura/nodes/haptic/device_info.h>
#include <pleura/nodes/standard/lighting/x3d_light_node.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>
#include <pleura/nodes/standard/shape/x3d_shape_node.h>
#include <pleura/nodes/standard/text/text.h>
#include <pleura/x3d/browser/render/draw_list.h>
#include <pleura/x3d/browser/render/text_geometry.h>
#include <pleura/x3d/browser/scene/scene.h>
#include <pleura/x3d/browser/view/camera.h>

namespace pleura {

/// What there is to see of a scene, as the renderer takes it. Pulls what is displayed, and nothing else: a
/// hidden organ is not computed. Lives as long as the scene.
class SceneView {
 public:
  explicit SceneView(Scene& scene) : scene_(scene) {}

  /// Looks from that viewpoint instead of the bound one. Throws std::invalid_argument when the scene has no
  /// viewpoint of that name.
  void lookFrom(std::string_view viewpoint);
  /// Looks through this camera instead; nothing: through the viewpoint again.
  void lookThrough(std::optional<render::Camera> camera) { override_ = std::move(camera); }

  /// Brings the list up to date with the scene. It stays valid until the next call.
  render::DrawList& update();

  /// Of update()'s viewpoint, without lookThrough().
  const PlacedCamera& viewpoint() const { return viewpoint_; }
  const Eigen::AlignedBox3f& box() const { return box_; }

 private:
  struct Drawn {
    NodePtr keepAlive;
    render::Geometry geometry;
    render::TextGeometry text;
    std::uint64_t textStamp = 0;
    bool isSound = false;
    std::uint64_t frame = 0;
  };

  /// A shape that is displayed, where it stands and what lights it.
  struct Seen {
    X3DShapeNode* shape;
    Matrix4f toWorld;
    std::uint32_t lights;
  };

  /// Whether the renderer takes it; if not, the author is told why the node is not drawn.
  template <class Drawable>
  bool isDrawable(const Node& node, const Drawable& drawable);
  void findBound();
  void locate(const NodePtr& node, const Matrix4f& toWorld);
  void visit(const NodePtr& node, const Matrix4f& toWorld, std::uint32_t lights);
  void visitAll(std::span<const NodePtr> nodes, const Matrix4f& toWorld, std::uint32_t lights);
  std::uint32_t lightsAmong(std::span<const NodePtr> nodes, const Matrix4f& toWorld);
  /// The styli of the devices in use, where their tips are.
  void visitStyli(DeviceInfo& info, std::uint32_t lights);
  void addShape(const Seen& one);
  render::Geometry* geometryOf(const NodePtr& node);
  static void updateMesh(render::Geometry& out, const RenderMesh& mesh);
  void updateText(Drawn& drawn, Text& text);
  void setCamera();
  void setBackground();

  Scene& scene_;
  std::optional<render::Camera> override_;
  Node* chosenViewpoint_ = nullptr;

  std::vector<Seen> seen_;  // in this update
  render::DrawList list_;
  std::unordered_map<const Node*, Drawn> drawn_;
  std::uint64_t frame_ = 0;
  std::uint32_t globalLights_ = 0;
  Eigen::AlignedBox3f box_;
  PlacedCamera viewpoint_;
  Node* boundViewpoint_ = nullptr;
  Node* boundBackground_ = nullptr;
  Matrix4f viewpointToWorld_ = Matrix4f::Identity();
  Matrix4f backgroundToWorld_ = Matrix4f::Identity();
};

}  // namespace pleura
