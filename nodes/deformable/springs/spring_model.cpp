#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <pleura/nodes/deformable/mesh/edge_uses.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/deformable/springs/spring_model.h>

namespace pleura {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument("springs: " + why); }

bool isIn(double x, double low, double high) { return std::isfinite(x) && x >= low && x <= high; }

void requireFew(std::size_t count, std::size_t most, const char* what) {
  if (count > most)
    refuse(std::to_string(count) + " " + what + ", at most " + std::to_string(most) + " are taken");
}

void requireInRange(std::span<const Eigen::Vector3f> rest) {
  for (std::size_t i = 0; i < rest.size(); ++i)
    for (const float x : rest[i])
      if (!isIn(x, -kSpringFarthest, kSpringFarthest))
        refuse("rest point " + std::to_string(i) + " is not finite, or too far away");
}

/// One value for each of `count`, from as many or from one.
std::vector<double> spread(const std::vector<double>& values, std::size_t count, const char* name,
                           double lowest, const char* rule) {
  if (values.size() != 1 && values.size() != count)
    refuse(std::to_string(values.size()) + " values of " + name + " for " + std::to_string(count));
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!isIn(values[i], lowest, kSpringFarthest))
      refuse(std::string(name) + " " + std::to_string(i) + " must be " + rule + ", and finite");
  return values.size() == count ? values : std::vector<double>(count, values[0]);
}

void requireSound(const SpringInterior& interior) {
  if (const auto* gas = std::get_if<GasInterior>(&interior)) {
    if (!isIn(gas->amount, 0, kSpringFarthest)) refuse("the amount of gas must be 0 or more, and finite");
    if (!isIn(gas->ambientPressure, 0, kSpringFarthest))
      refuse("the ambient pressure must be 0 or more, and finite");
  }
  if (const auto* pressure = std::get_if<PressureInterior>(&interior))
    if (!isIn(pressure->difference, -kSpringFarthest, kSpringFarthest))
      refuse("the pressure difference must be finite");
}

// Every edge run through as often one way as the other: then the surface has no boundary, and its volume does
// not depend on where it is measured from.
void requireClosed(std::span<const Eigen::Vector3i> triangles) {
  const std::vector<EdgeUse> uses = edgeUses(triangles);
  forEachEdge(uses, [](std::span<const EdgeUse> edge) {
    const auto forward =
        std::count_if(edge.begin(), edge.end(), [](const EdgeUse& use) { return use.forward; });
    if (2 * static_cast<std::size_t>(forward) != edge.size())
      refuse(
          "an interior needs a closed surface, its triangles facing outwards; it is open, or turned, at the "
          "edge " +
          std::to_string(edge[0].low) + " - " + std::to_string(edge[0].high));
  });
}

void enclose(SpringModel& model, std::span<const Eigen::Vector3f> rest,
             std::span<const Eigen::Vector3i> triangles, const SpringInterior& interior) {
  requireSound(interior);
  model.interior = interior;
  if (std::holds_alternative<EmptyInterior>(interior)) return;
  requireClosed(triangles);
  model.restVolume = signedVolume(rest, triangles);
  if (model.restVolume <= 1e-12 * std::pow(model.extent, 3))
    refuse("an interior needs a surface around a volume, its triangles facing outwards");
  model.triangles.assign(triangles.begin(), triangles.end());
}

// A surface of springs stretched evenly resists with dp/dV = K / V, K = sum(k l^2) / 9 V. Held a hundred
// times stiffer, each change of the multiplier leaves about a hundredth of the excess volume.
void measure(SpringModel& model) {
  const double leastLength = model.extent > 0 ? 1e-4 * model.extent : 1e-4;
  std::vector<double> force(model.rest.size(), 0);
  double sum = 0;
  for (int a = 0; a < model.pointCount(); ++a)
    for (int s = model.begin[a]; s < model.begin[a + 1]; ++s) {
      const double kl = model.stiffness[s] * std::max(model.length[s], leastLength);
      force[a] += kl;
      force[model.end[s]] += kl;
      sum += kl * model.length[s];
    }
  double squares = 0;
  for (const double f : force) squares += f * f;
  model.forceUnit = std::sqrt(squares);
  if (model.restVolume > 0) model.holdModulus = 100 * sum / (9 * model.restVolume);
}

}  // namespace

SpringModel makeSpringModel(std::span<const Eigen::Vector3f> rest, std::span<const Eigen::Vector3i> triangles,
                            const SpringMaterial& material, const SpringInterior& interior) {
  if (triangles.empty()) refuse("no triangles");
  requireFew(rest.size(), kMostSpringPoints, "points");
  requireFew(triangles.size(), kMostSpringTriangles, "triangles");
  requireInRange(rest);
  const std::vector<Eigen::Vector2i> pairs = edges(rest.size(), triangles);
  SpringModel model;
  model.extent = boundingBox(rest).sizes().cast<double>().maxCoeff();
  for (const Eigen::Vector3f& point : rest) model.rest.push_back(point.cast<double>());
  model.stiffness = spread(material.stiffness, pairs.size(), "stiffness", 1e-12, "above 0");
  model.mass = spread(material.mass, rest.size(), "mass", 0, "0 or more");
  if (!isIn(material.relaxationTime, 0, kSpringFarthest))
    refuse("the relaxation time must be 0 or more, and finite");
  model.relaxationTime = material.relaxationTime;
  model.begin.assign(rest.size() + 1, 0);
  for (const Eigen::Vector2i& pair : pairs) {
    ++model.begin[pair[0] + 1];
    model.end.push_back(pair[1]);
    model.length.push_back((model.rest[pair[1]] - model.rest[pair[0]]).norm());
  }
  for (std::size_t i = 1; i < model.begin.size(); ++i) model.begin[i] += model.begin[i - 1];
  enclose(model, rest, triangles, interior);
  measure(model);
  return model;
}

}  // namespace pleura
