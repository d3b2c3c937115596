#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <pleura/x3d/browser/render/draw_list.h>

namespace pleura::render {

/// X3D's EXAMINE navigation: a camera that turns about a centre with +Y up. Pure, knows no window; pixels are
/// the mouse's, +y down, and what is under the mouse follows it.
class OrbitCamera {
 public:
  /// Starts from a viewpoint. Throws std::invalid_argument if its view or the centre is not finite.
  OrbitCamera(const Camera& viewpoint, const Eigen::Vector3f& center);

  /// The viewpoint moved by all that was done since the start or the last reset.
  const Camera& camera() const { return camera_; }
  const Eigen::Vector3f& center() const { return center_; }

  /// Turns about the centre, half a turn for a drag over the picture's height; stops at the poles.
  void orbit(float pixelsX, float pixelsY, int pictureHeight);

  /// Moves camera and centre in the picture's plane.
  void pan(float pixelsX, float pixelsY, int pictureWidth, int pictureHeight);

  /// Comes nearer by a tenth of the distance for each step of the wheel; never reaches the centre.
  void zoom(float steps);

  /// Keeps the direction of view, makes the box's middle the centre and shows all of it. Throws
  /// std::invalid_argument for a box that is empty or not finite.
  void fit(const Eigen::AlignedBox3f& box);

  /// Back to the viewpoint and its centre.
  void reset();

 private:
  Eigen::Vector3f centerInView() const;
  void move(const Eigen::Vector3f& offset);  // the world, in view space

  Camera viewpoint_, camera_;
  Eigen::Vector3f viewpointCenter_, center_;
};

}  // namespace pleura::render
