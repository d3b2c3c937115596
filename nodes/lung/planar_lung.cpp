#include <algorithm>

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/lung/planar_chest.h>
#include <pleura/nodes/lung/planar_lung.h>

namespace pleura {

namespace {

void append(std::span<const Eigen::Vector2d> points, std::vector<Vec3f>& to) {
  for (const Eigen::Vector2d& p : points)
    to.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0f);
}

void setTriangles(std::span<const Eigen::Vector3i> triangles, std::vector<int>& index) {
  index.clear();
  for (const Eigen::Vector3i& t : triangles) index.insert(index.end(), t.begin(), t.end());
}

}  // namespace

void PlanarLung::declare(NodeType& type) {
  Node::declare(type);
  type.named("PlanarLung", "Pleura")
      .containedIn("lungs")
      .means("a lung of a PlanarChest, in a coronal section");
  using enum Access;
  const planar::LungTissue tissue;
  const planar::HemithoraxShape shape;
  type.field<&PlanarLung::isRight>("isRight", initializeOnly, false).means("the right lung, at -x");
  type.field<&PlanarLung::youngsModulus>("youngsModulus", initializeOnly,
                                         static_cast<float>(tissue.youngsModulus))
      .measuredIn(Unit::pressure)
      .positive(1e9)
      .means("at 2000 Pa the lung fills its cavity at -5 cmH2O");
  type.field<&PlanarLung::poissonRatio>("poissonRatio", initializeOnly,
                                        static_cast<float>(tissue.poissonsRatio))
      .within(0, 0.49995)
      .means("of lung tissue and air together");
  type.field<&PlanarLung::density>("density", initializeOnly, static_cast<float>(tissue.density))
      .measuredIn(Unit::density)
      .positive(1e5)
      .means("of lung tissue and air together");
  type.field<&PlanarLung::relaxationTime>("relaxationTime", initializeOnly,
                                          static_cast<float>(tissue.relaxationTime))
      .measuredIn(Unit::time)
      .within(0, 1e3)
      .means("viscosity over stiffness");
  type.field<&PlanarLung::rings>("rings", initializeOnly, shape.rings)
      .within(3, 48)
      .means("of elements, from the middle to the outline; 6 rings^2 triangles");
  type.field<&PlanarLung::pneumothorax>("pneumothorax", inputOutput, false)
      .means("an open wound: intrapleural pressure is atmospheric; when it is closed the air is drawn out");
  type.field<&PlanarLung::lungIndex>("lungIndex", outputOnly, {}).means("triangles of the lung");
  type.field<&PlanarLung::lungPoint>("lungPoint", outputOnly, {})
      .measuredIn(Unit::length)
      .means("their points");
  type.field<&PlanarLung::pleuraIndex>("pleuraIndex", outputOnly, {})
      .means("triangles of the intrapleural space");
  type.field<&PlanarLung::pleuraPoint>("pleuraPoint", outputOnly, {})
      .measuredIn(Unit::length)
      .means("their points");
  type.field<&PlanarLung::wallIndex>("wallIndex", outputOnly, {})
      .means("the wall as a line, for IndexedLineSet; a wound is a gap in it");
  type.field<&PlanarLung::wallPoint>("wallPoint", outputOnly, {})
      .measuredIn(Unit::length)
      .means("its points");
  type.field<&PlanarLung::intrapleuralPressure>("intrapleuralPressure", outputOnly, 0)
      .measuredIn(Unit::pressure)
      .means("above ambient");
  type.field<&PlanarLung::lungVolume>("lungVolume", outputOnly, 0)
      .measuredIn(Unit::volume)
      .means("area times the chest's thickness");
}

planar::SideParameters PlanarLung::parameters() {
  planar::SideParameters side;
  side.shape.rings = rings.getValue(id);
  side.shape.isMirrored = isRight.getValue(id);
  side.tissue = {.youngsModulus = youngsModulus.getValue(id),
                 .poissonsRatio = poissonRatio.getValue(id),
                 .density = density.getValue(id),
                 .relaxationTime = relaxationTime.getValue(id)};
  return side;
}

void PlanarLung::join(PlanarChest& chest, std::size_t number) {
  chest_ = &chest;
  number_ = number;
  for (Field* output :
       std::initializer_list<Field*>{&lungIndex, &lungPoint, &pleuraIndex, &pleuraPoint, &wallIndex,
                                     &wallPoint, &intrapleuralPressure, &lungVolume})
    context().time.routeNoEvent(*output, id);
}

PlanarLungSystem* PlanarLung::now() { return chest_ != nullptr ? chest_->now() : nullptr; }

void PlanarLung::fillLungIndex(std::vector<int>& index) {
  if (auto* system = now()) setTriangles(system->hemithorax(number_).lung.triangles, index);
}

void PlanarLung::fillLungPoint(std::vector<Vec3f>& points) {
  points.clear();
  auto* system = now();
  if (system == nullptr) return;
  placed_.resize(system->hemithorax(number_).lung.points.size());
  system->placeLung(number_, placed_);
  append(placed_, points);
}

void PlanarLung::fillPleuraIndex(std::vector<int>& index) {
  if (auto* system = now()) setTriangles(system->hemithorax(number_).strip, index);
}

/// The lung's outline, and then the wall.
void PlanarLung::fillPleuraPoint(std::vector<Vec3f>& points) {
  points = lungPoint.getValue(id);
  auto* system = now();
  if (system == nullptr) return;
  points.resize(static_cast<std::size_t>(system->hemithorax(number_).lung.outlineCount));
  append(system->wallPoints(number_), points);
}

void PlanarLung::fillWallIndex(std::vector<int>& index) {
  auto* system = now();
  if (system == nullptr) return;
  index = system->hemithorax(number_).wallLine(!system->isSealed(number_));
  index.push_back(-1);
}

void PlanarLung::fillWallPoint(std::vector<Vec3f>& points) {
  points.clear();
  if (auto* system = now()) append(system->wallPoints(number_), points);
}

void PlanarLung::fillPressure(float& pressure) {
  if (auto* system = now()) pressure = static_cast<float>(system->pressure(number_));
}

void PlanarLung::fillVolume(float& volume) {
  if (auto* system = now())
    volume = static_cast<float>(system->lungArea(number_) * chest_->thickness.getValue());
}

}  // namespace pleura
