#include <pleura/nodes/deformable/springs/spring_workspace.h>

namespace pleura {

SpringWorkspace::SpringWorkspace(const SpringModel& model) {
  const std::size_t points = model.rest.size(), springs = model.end.size();
  for (auto* values : {&stiffness, &length}) values->resize(springs);
  for (auto* values : {&inertia, &diagonal}) values->resize(points);
  for (Vectors* vectors : {&predicted, &position, &gradient, &volumeGradient, &trial, &direction, &residual,
                           &preconditioned, &search, &product, &preconditionedVolume})
    vectors->assign(points, Eigen::Vector3d::Zero());
  isDriven.assign(points, 0);
  tangent.resize(springs);
  preconditioner.resize(points);
}

}  // namespace pleura
