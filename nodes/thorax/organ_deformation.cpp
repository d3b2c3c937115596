#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/thorax/organ_deformation.h>

namespace pleura {

void OrganDeformation::declare(NodeType& type) {
  Node::declare(type);
  type.named("OrganDeformation", "Pleura").means("chooses how an organ deforms between its contacts");
  using enum Access;
  type.field<&OrganDeformation::contacts>("contacts", initializeOnly, {})
      .means("the LungContacts or DiaphragmContacts that hold the organ");
  type.field<&OrganDeformation::deformer>("deformer", initializeOnly, {})
      .means("moves the points that no wall moves");
  type.field<&OrganDeformation::tolerance>("tolerance", initializeOnly, 0)
      .measuredIn(Unit::length)
      .within(0, 1)
      .means("most RMS error that a deformer may have which is chosen; 0: any");
  type.field<&OrganDeformation::budget>("budget", initializeOnly, 0)
      .measuredIn(Unit::time)
      .within(0, 1e3)
      .means("most time that it may take for a shape; 0: any");
  type.field<&OrganDeformation::chosen>("chosen", outputOnly, "")
      .means("type of the deformer that moves the organ; empty: the contacts fill in");
}

void OrganDeformation::onInitialize() {
  auto* held = contacts.get();
  auto* organ = held != nullptr ? held->organ.get() : nullptr;
  if (organ == nullptr)
    return context().warn(*this, "contacts is missing: LungContacts or DiaphragmContacts are expected");
  NodePtr used = deformer.getValue(id);
  if (!used && tolerance.getValue(id) <= 0 && budget.getValue(id) <= 0)
    return context().warn(*this, "deformer is missing, and neither tolerance nor budget asks for one");
  if (!used) used = choose(*organ);
  if (!used) return;
  held->fillsBetween.setValue(false);
  organ->deformBy(used);
  chosen.setValue(used->type().name(), id);
}

NodePtr OrganDeformation::choose(DeformableShape2& organ) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const double error = tolerance.getValue(id) > 0 ? tolerance.getValue(id) : kAny;
  const double cost = budget.getValue(id) > 0 ? budget.getValue(id) : kAny;
  auto figures = context().deformationFigures();
  std::erase_if(figures, [&](const DeformationFigure& f) { return f.organ != organ.describe(); });
  if (figures.empty()) {
    context().warn(
        *this,
        organ.describe() + " was not measured on this machine, by pleura tradeoff: it is filled in smoothly");
    return nullptr;
  }
  const auto better = [](const DeformationFigure& a, const DeformationFigure& b) {
    return std::pair(a.cost, a.error) < std::pair(b.cost, b.error);
  };
  std::sort(figures.begin(), figures.end(), better);
  const auto holds = std::find_if(figures.begin(), figures.end(), [&](const DeformationFigure& f) {
    return f.error <= error && f.cost <= cost;
  });
  if (holds != figures.end()) return made(*holds);
  // What is nearest to the tolerance within the budget, or else the cheapest.
  const DeformationFigure* nearest = &figures.front();
  for (const auto& f : figures)
    if (f.cost <= cost && f.error < nearest->error) nearest = &f;
  context().warn(
      *this,
      fmt::format("no way to deform {} is known to hold tolerance {} m and budget {} s: {} has {:.2g} m "
                  "in {:.2g} s, and is taken",
                  organ.describe(), tolerance.getValue(id), budget.getValue(id),
                  nearest->deformer.empty() ? "the smooth fill" : nearest->deformer, nearest->error,
                  nearest->cost));
  return made(*nearest);
}

NodePtr OrganDeformation::made(const DeformationFigure& figure) {
  if (figure.deformer.empty()) return nullptr;
  NodePtr node = context().make(figure.deformer);
  if (!node) return nullptr;
  for (const auto& [field, text] : figure.fields) node->getField(field)->setValueFromString(text);
  node->initialize(context());
  return node;
}

}  // namespace pleura
