#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/grouping/transform.h>

namespace pleura {

void Transform::declare(NodeType& type) {
  X3DGroupingNode::declare(type);
  type.named("Transform", "Grouping", 1).means("children in a coordinate system of their own");
  using enum Access;
  type.field<&Transform::center>("center", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("point that rotation and scale leave where it is");
  type.field<&Transform::rotation>("rotation", inputOutput, Rotation())
      .measuredIn(Unit::angle)
      .means("turn about the centre");
  type.field<&Transform::scale>("scale", inputOutput, Vec3f(1, 1, 1))
      .means("factors along the axes of scaleOrientation");
  type.field<&Transform::scaleOrientation>("scaleOrientation", inputOutput, Rotation())
      .measuredIn(Unit::angle)
      .means("turn of the axes along which it is scaled");
  type.field<&Transform::translation>("translation", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("shift, after all else");
}

Transform::Transform() {
  translation.route(matrix);
  rotation.route(matrix);
  scale.route(matrix);
  scaleOrientation.route(matrix);
  center.route(matrix);
}

// P' = T C R SR S -SR -C P (ISO/IEC 19775-1, 10.4.4)
void Transform::Matrix::update() {
  const auto vector = [this](std::size_t i) { return static_cast<SFVec3f*>(routes_in[i])->getValue(); };
  const auto turn = [this](std::size_t i) {
    return static_cast<SFRotation*>(routes_in[i])->getValue().quaternion();
  };
  const Eigen::Translation3f T(vector(0)), C(vector(4));
  const auto R = turn(1), SR = turn(3);
  const Eigen::DiagonalMatrix<float, 3> S(vector(2));
  const Eigen::Affine3f M = T * C * R * SR * S * SR.conjugate() * C.inverse();
  value = M.matrix();
}

}  // namespace pleura
