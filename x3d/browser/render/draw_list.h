#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pleura::render {

enum class Primitive { Triangles, Lines, Points };

/// A shape as views of arrays that the caller owns and keeps alive until Renderer::draw() returns. Raise a
/// stream's revision when its values change: only such streams are sent to the GPU again. Positions and
/// normals change each tick of an organ, indices hardly ever. The GPU's copy lives as long as the Geometry.
struct Geometry {
  Geometry() = default;
  Geometry(Geometry&&) = default;
  Geometry& operator=(Geometry&&) = default;

  Primitive primitive = Primitive::Triangles;
  std::span<const Eigen::Vector3f> positions;  // [m]
  std::span<const Eigen::Vector3f> normals;    // one a position; empty: flat facets
  std::span<const Eigen::Vector4f> colors;     // one a position, RGBA in [0, 1]; empty: the material's
  std::span<const std::uint32_t> indices;      // three a triangle, two a line, one a point
  bool ccw = true;                             // front faces are counterclockwise
  bool solid = true;  // back faces are not drawn; false: both sides, each lit as a front
  std::uint64_t positionsRevision = 0;
  std::uint64_t normalsRevision = 0;
  std::uint64_t colorsRevision = 0;
  std::uint64_t indicesRevision = 0;
  std::shared_ptr<const char> identity =
      std::make_shared<const char>();  // tells this Geometry from a later one here
};

/// X3D Material; `lit` false is UnlitMaterial or no Material at all, which shows emissiveColor only. Lines
/// and points are always unlit. A Geometry's colours stand for diffuseColor where lit, for emissiveColor
/// where not, and their alpha for 1 - transparency.
struct Material {
  Eigen::Vector3f diffuseColor = Eigen::Vector3f::Constant(0.8f);
  Eigen::Vector3f specularColor = Eigen::Vector3f::Zero();
  Eigen::Vector3f emissiveColor = Eigen::Vector3f::Zero();
  float ambientIntensity = 0.2f;
  float shininess = 0.2f;  // [0, 1], 128 times the exponent
  float transparency = 0.0f;
  bool lit = true;
};

/// One shape in the world. Bit i of `lights` says whether DrawList::lights[i] shines on it (X3D scopes a
/// DirectionalLight with global FALSE to its group).
struct DrawItem {
  const Geometry* geometry = nullptr;
  Eigen::Matrix4f model = Eigen::Matrix4f::Identity();  // to world space
  Material material = {};
  std::uint32_t lights = ~0u;
  float size = 1.0f;  // of points and lines [pixel]; lines as wide as the OpenGL at hand can
};

/// X3D DirectionalLight, PointLight or SpotLight, already in world space.
struct Light {
  enum class Kind { Directional, Point, Spot };
  Kind kind = Kind::Directional;
  Eigen::Vector3f color = Eigen::Vector3f::Ones();
  float intensity = 1.0f;
  float ambientIntensity = 0.0f;
  Eigen::Vector3f direction{0, 0, -1};   // directional and spot
  Eigen::Vector3f location{0, 0, 0};     // point and spot [m]
  Eigen::Vector3f attenuation{1, 0, 0};  // constant, linear, quadratic in distance
  float radius = 100.0f;                 // of point and spot [m]
  float beamWidth = 0.7853982f;          // full intensity up to this angle from the axis [rad]
  float cutOffAngle = 1.5707963f;        // dark from this angle on [rad]
};

/// The most lights one DrawList may hold, the headlight aside.
inline constexpr std::size_t maxLights = 15;

/// X3D OrthoViewpoint.fieldOfView: the least extent shown, in view space [m].
struct OrthographicExtent {
  float left = -1, bottom = -1, right = 1, top = 1;
};

/// X3D Viewpoint or, where `orthographic` is set, OrthoViewpoint.
struct Camera {
  Eigen::Matrix4f view = Eigen::Matrix4f::Identity();  // world to view; the camera looks along -Z, +Y is up
  float fieldOfView = 0.7853982f;                      // of the smaller side of the picture [rad]
  std::optional<OrthographicExtent> orthographic;
  float nearDistance = 0.01f;  // [m]
  float farDistance = 100.0f;  // [m]
};

/// X3D Background: colours by angle, sky from the zenith and ground from the nadir, each with one colour more
/// than angles. No ground colours: sky all round.
struct Background {
  std::vector<Eigen::Vector3f> skyColor{Eigen::Vector3f::Zero()};
  std::vector<float> skyAngle;  // rising, [0, pi] [rad]
  std::vector<Eigen::Vector3f> groundColor;
  std::vector<float> groundAngle;                          // rising, [0, pi/2] [rad]
  Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();  // to world space
};

enum class Justify { Begin, Middle, End };

/// Text on the picture's surface: labels, status. (x, y) is where its top line begins, is centred or ends.
struct OverlayText {
  std::string text;  // UTF-8; lines parted by '\n'
  float x = 0;       // from the left [pixel]
  float y = 0;       // from the top, to the top of the first line [pixel]
  float size = 16;   // distance of two lines [pixel]
  Eigen::Vector4f color{1, 1, 1, 1};
  Justify justify = Justify::Begin;
};

/// All that one frame shows. Keep it and change it from frame to frame; items may come in any order.
struct DrawList {
  std::vector<DrawItem> items;
  std::vector<Light> lights;  // at most maxLights
  Camera camera;
  Background background;
  bool headlight = true;  // a white directional light along the line of sight
  std::vector<OverlayText> overlay;
};

}  // namespace pleura::render
