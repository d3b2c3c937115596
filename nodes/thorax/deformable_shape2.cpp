#include <algorithm>
#include <stdexcept>

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/deformable/geometry_mesh.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/solve_counter.h>
#include <pleura/nodes/standard/rendering/coordinate.h>
#include <pleura/nodes/standard/rendering/x3d_composed_geometry_node.h>
#include <pleura/nodes/standard/shape/appearance.h>
#include <pleura/nodes/thorax/deformable_shape2.h>

namespace pleura {

void DeformableShape2::declare(NodeType& type) {
  X3DShapeNode::declare(type);
  type.named("DeformableShape2", "Pleura").means("an organ: a shape that deforms where its points are moved");
  using enum Access;
  type.field<&DeformableShape2::deformer>("deformer", inputOutput, {}).means("how the other points follow");
  type.field<&DeformableShape2::origCoord>("origCoord", inputOutput, {})
      .measuredIn(Unit::length)
      .means("the shape at rest; the geometry's own points when empty");
  type.field<&DeformableShape2::rigid_points>("rigid_points", inputOutput, {})
      .means("points that keep their places to one another");
  type.field<&DeformableShape2::contactIndex>("contactIndex", inputOutput, {})
      .means("the points that are moved");
  type.field<&DeformableShape2::contactPoint>("contactPoint", inputOutput, {})
      .measuredIn(Unit::length)
      .means("where they are moved to, one for each of contactIndex");
  type.field<&DeformableShape2::deformedCoord>("deformedCoord", outputOnly, {})
      .measuredIn(Unit::length)
      .means("the shape now, as it is without being touched");
  type.field<&DeformableShape2::touchedCoord>("touchedCoord", outputOnly, {})
      .measuredIn(Unit::length)
      .means("the shape now, pressed in where a haptic device touches a surface that gives way");
  type.field<&DeformableShape2::volume>("volume", outputOnly, 0)
      .measuredIn(Unit::volume)
      .means("what the deformed surface encloses");
  type.field<&DeformableShape2::top>("top", outputOnly, 0)
      .measuredIn(Unit::length)
      .means("height of the highest point of the deformed surface");
}

DeformableShape2::~DeformableShape2() {
  solve_.cancel();
  if (serving_) serving_->release(*this);
}

void DeformableShape2::onInitialize() {
  auto* composed = dynamic_cast<X3DComposedGeometryNode*>(geometry.get());
  auto* coordinate = composed != nullptr ? dynamic_cast<Coordinate*>(composed->coord.get()) : nullptr;
  if (coordinate == nullptr)
    return context().warn(*this, "the geometry has no Coordinate whose points could move");
  if (origCoord.empty()) origCoord.setValue(coordinate->point.getValue());
  for (Field* input :
       std::initializer_list<Field*>{&deformer, &origCoord, &rigid_points, &contactIndex, &contactPoint})
    input->routeNoEvent(deformedCoord, id);
  deformBy(deformer.getValue());
  deformedCoord.routeNoEvent(volume, id);
  deformedCoord.routeNoEvent(top, id);
  deformedCoord.routeNoEvent(touchedCoord, id);
  for (MFVec3f* touch : {&composed->contactPoint, &composed->contactNormal})
    touch->routeNoEvent(touchedCoord, id);
  composed->contactDepth.routeNoEvent(touchedCoord, id);
  touchedCoord.routeNoEvent(coordinate->point);
  origCoord.touch();
}

void DeformableShape2::hearDeformer() {
  auto solver = std::dynamic_pointer_cast<DeformerNode>(deformer.getValue());
  if (!solver) return;
  for (Field* input : solver->inputs()) input->routeNoEvent(deformedCoord, id);
  serveBy(std::move(solver));
}

void DeformableShape2::deformBy(const NodePtr& chosen) {
  deformer.setValue(chosen);
  try {
    hearDeformer();
  } catch (const std::invalid_argument& refused) {
    context().warn(*this, refused.what());
  }
}

bool DeformableShape2::givesWay() {
  auto* looks = dynamic_cast<Appearance*>(appearance.get());
  auto* surface = looks != nullptr ? looks->surface.get() : nullptr;
  return surface != nullptr && surface->givesWay();
}

const TriangleMesh& DeformableShape2::rest() {
  const std::array<std::uint64_t, 2> stamps = {origCoord.getStamp(), geometry.getStamp()};
  if (stamps == meshStamps_ || geometry.get() == nullptr) return rest_;
  meshStamps_ = stamps;
  rest_.points = origCoord.getValue();
  rest_.triangles = trianglesOf(*geometry.get(), rest_.points.size());
  return rest_;
}

void DeformableShape2::serveBy(std::shared_ptr<DeformerNode> solver) {
  if (solver == serving_) return;
  solve_.cancel();
  preparedFor_ = 0;
  if (serving_) serving_->release(*this);
  serving_ = nullptr;
  if (solver && !solver->serves(*this))
    throw std::invalid_argument("deformer: " + solver->describe() +
                                " serves another shape, and no second one");
  serving_ = std::move(solver);
}

void DeformableShape2::takeRest() {
  const TriangleMesh& shape = rest();
  slot_.assign(shape.points.size(), -1);
  hearDeformer();
  serving_->setRest(shape, restRigid_);
}

std::uint64_t DeformableShape2::restStamp(DeformerNode& solver) {
  std::uint64_t stamp = std::max(deformer.getStamp(), origCoord.getStamp());
  if (!usable_)
    for (const Field* input : solver.inputs()) stamp = std::max(stamp, input->getStamp());
  return stamp;
}

void DeformableShape2::gatherContacts() {
  const auto& index = contactIndex.getValue();
  const auto& point = contactPoint.getValue();
  for (std::size_t i = 0; i < std::min(index.size(), point.size()); ++i) drive(index[i], point[i]);
}

void DeformableShape2::drive(int point, const Vec3f& target) {
  if (point < 0 || point >= static_cast<int>(slot_.size())) return;
  int& slot = slot_[static_cast<std::size_t>(point)];
  if (slot >= 0) {
    targets_[static_cast<std::size_t>(slot)] = target;
    return;
  }
  slot = static_cast<int>(driven_.size());
  driven_.push_back(point);
  targets_.push_back(target);
}

std::uint64_t DeformableShape2::inputStamp() {
  std::uint64_t stamp = 0;
  const auto& inputs = deformedCoord.getRoutesIn();
  for (std::size_t i = 0; i < inputs.size(); ++i) {  // in a cycle one more may come meanwhile
    inputs[i]->upToDate();
    stamp = std::max(stamp, inputs[i]->getStamp());
  }
  return stamp;
}

void DeformableShape2::begin() {
  if (deformedCoord.isUpToDate()) return;
  const std::uint64_t inputs = inputStamp();
  if (deformedCoord.isUpToDate() || inputs == preparedFor_) return;
  prepare(inputs);
  if (answer_ == Answer::solved) solve_.offer();
}

void DeformableShape2::prepare(std::uint64_t inputs) {
  solve_.cancel();
  preparedFor_ = inputs;
  answer_ = Answer::none;
  auto* solver = deformer.get();
  if (solver == nullptr) return serveBy(nullptr);
  if (origCoord.empty()) return;
  try {
    const std::uint64_t stamp = restStamp(*solver);
    const auto& rigid = rigidPoints();
    if (stamp > restStamp_ || rigid != restRigid_) {
      restStamp_ = stamp;
      restRigid_ = rigid;
      usable_ = false;
      takeRest();
      usable_ = true;
    }
    if (!usable_) return;
    driven_.clear();
    targets_.clear();
    gatherContacts();
    for (const int point : driven_) slot_[static_cast<std::size_t>(point)] = -1;
    ++solveCounter();
    if (driven_.size() == origCoord.size()) return void(answer_ = Answer::targets);
    solver->prepare(driven_);
    solved_.resize(origCoord.size());
    answer_ = Answer::solved;
  } catch (const std::invalid_argument& refused) {
    context().warn(*this, refused.what());
  }
}

void DeformableShape2::takeTargets(std::vector<Vec3f>& positions) {
  if (!std::all_of(targets_.begin(), targets_.end(), [](const Vec3f& p) { return isFinite(p); }))
    throw std::invalid_argument("contactPoint: a point that is not finite");
  for (std::size_t i = 0; i < driven_.size(); ++i)
    positions[static_cast<std::size_t>(driven_[i])] = targets_[i];
}

void DeformableShape2::takeSolved(std::vector<Vec3f>& positions) {
  solve_.finish();
  positions.swap(solved_);
  serving_->report();
}

void DeformableShape2::deform(std::vector<Vec3f>& positions) {
  if (origCoord.empty()) return positions.clear();
  if (positions.size() != origCoord.size()) positions = origCoord.getValue();
  if (const std::uint64_t inputs = inputStamp(); inputs != preparedFor_) prepare(inputs);
  preparedFor_ = 0;
  try {
    if (answer_ == Answer::targets) takeTargets(positions);
    if (answer_ == Answer::solved) takeSolved(positions);
  } catch (const std::invalid_argument& refused) {
    context().warn(*this, refused.what());
  }
}

void DeformableShape2::Touched::update() {
  auto& node = *static_cast<DeformableShape2*>(getOwner());
  value = static_cast<MFVec3f*>(routes_in[0])->getValue();
  const auto& point = static_cast<MFVec3f*>(routes_in[1])->getValue();
  const auto& normal = static_cast<MFVec3f*>(routes_in[2])->getValue();
  const auto& depth = static_cast<MFFloat*>(routes_in[3])->getValue();
  if (depth.empty() || !node.givesWay()) return;
  auto* solver = node.deformer.get();
  for (std::size_t i = 0; i < std::min({point.size(), normal.size(), depth.size()}); ++i) {
    const Dent dent{.point = point[i], .normal = normal[i], .depth = depth[i]};
    solver != nullptr ? solver->give(dent, node.rest().triangles, value)
                      : void(press(dent, node.rest().triangles, value));
  }
}

void DeformableShape2::Volume::update() {
  auto& node = *static_cast<DeformableShape2*>(getOwner());
  const auto& points = static_cast<MFVec3f*>(routes_in[0])->getValue();
  value = static_cast<float>(signedVolume(points, node.rest().triangles));
}

void DeformableShape2::Top::update() {
  const auto& points = static_cast<MFVec3f*>(routes_in[0])->getValue();
  value = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    value = i == 0 ? points[i].y() : std::max(value, points[i].y());
}

}  // namespace pleura
