#include <pleura/x3d/browser/view/billboard_turn.h>
#include <pleura/x3d/browser/view/camera.h>

namespace pleura {

Matrix4f billboardTurn(Billboard& node, const Matrix4f& toWorld, const Matrix4f& view) {
  Matrix4f turn = Matrix4f::Identity();
  const Matrix4f localToView = view * toWorld;
  const Matrix3f axes = localToView.topLeftCorner<3, 3>();
  if (std::abs(axes.determinant()) < 1e-12f) return turn;
  const Matrix3f fromView = axes.inverse();
  const Vec3f viewer = viewerIn(localToView);
  const Vec3f axis = node.axisOfRotation.getValue();
  if (axis.norm() == 0) {
    // faces the screen, its +Y along the viewer's up
    turn.topLeftCorner<3, 3>() = fromView;
    for (int i = 0; i < 3; ++i) turn.col(i).head<3>().normalize();
    return turn;
  }
  const Vec3f a = axis.normalized();
  const Vec3f toViewer = viewer - viewer.dot(a) * a;
  const Vec3f front = Vec3f::UnitZ() - a.z() * a;
  if (toViewer.norm() < 1e-9f || front.norm() < 1e-9f) return turn;
  const float angle = std::atan2(a.dot(front.cross(toViewer)), front.dot(toViewer));
  turn.topLeftCorner<3, 3>() = Eigen::AngleAxisf(angle, a).toRotationMatrix();
  return turn;
}

}  // namespace pleura
