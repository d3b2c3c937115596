#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <pleura/nodes/deformable/chainmail/chainmail_model.h>
#include <pleura/nodes/deformable/chainmail/chainmail_range.h>

namespace pleura {
namespace {

void requireValid(const ChainmailMaterial& m, std::size_t index) {
  const auto refuse = [&](const char* rule) {
    throw std::invalid_argument("chainmail: material " + std::to_string(index) + ": " + rule);
  };
  if (!std::isfinite(m.compression) || m.compression < 0 || m.compression > 1)
    refuse("compression must be from 0 to 1");
  if (!std::isfinite(m.stretch) || m.stretch < 1) refuse("stretch must be 1 or more, and finite");
  if (!std::isfinite(m.shear) || m.shear < 0) refuse("shear must be 0 or more, and finite");
}

// With rest offset d = b0 - a0 and s_x = shear (|d_y| + |d_z|), Li and Brodlie hold b in
//   a + compression d - s <= b <= a + stretch d + s          (per axis, mirrored where d < 0).
// In displacements u = position - rest that is  u_a - u_b <= slack(+)  and  u_b - u_a <= slack(-)  with
//   slack(+) = (1 - compression) d + s,  slack(-) = (stretch - 1) d + s          (exchanged where d < 0).
ChainmailPull linkSlack(const Eigen::Vector3d& d, const ChainmailMaterial& a, const ChainmailMaterial& b) {
  const double compression = (double(a.compression) + b.compression) / 2;
  const double stretch = (double(a.stretch) + b.stretch) / 2;
  const double shear = (double(a.shear) + b.shear) / 2;
  ChainmailPull slack = ChainmailPull::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double length = std::abs(d[axis]);
    const double s = shear * (std::abs(d[(axis + 1) % 3]) + std::abs(d[(axis + 2) % 3]));
    double ahead = (1 - compression) * length + s;
    double behind = (stretch - 1) * length + s;
    if (d[axis] < 0) std::swap(ahead, behind);
    slack[axis] = static_cast<float>(std::min(ahead, double(kChainmailFarthest)));
    slack[axis + 4] = static_cast<float>(std::min(behind, double(kChainmailFarthest)));
  }
  return slack;
}

}  // namespace

ChainmailModel makeChainmailModel(std::span<const Eigen::Vector3f> rest, const ChainmailTopology& topology,
                                  std::span<const ChainmailMaterial> material) {
  if (rest.size() + 1 != topology.begin.size())
    throw std::invalid_argument("chainmail: rest has " + std::to_string(rest.size()) +
                                " points, the topology " + std::to_string(topology.pointCount()));
  for (std::size_t i = 0; i < rest.size(); ++i)
    requireInChainmailRange("rest point", static_cast<int>(i), rest[i]);
  ChainmailModel model;
  model.rest.assign(rest.begin(), rest.end());
  model.order = breadthFirstOrder(topology);
  model.topology = renumber(topology, model.order);
  setMaterial(model, material);
  return model;
}

void setMaterial(ChainmailModel& model, std::span<const ChainmailMaterial> material) {
  if (material.size() != 1 && material.size() != model.rest.size())
    throw std::invalid_argument("chainmail: material has " + std::to_string(material.size()) +
                                " entries for " + std::to_string(model.rest.size()) + " points");
  for (std::size_t i = 0; i < material.size(); ++i) requireValid(material[i], i);
  const auto materialOf = [&](int point) { return material[material.size() == 1 ? 0 : point]; };
  const ChainmailTopology& topology = model.topology;
  model.slack.resize(topology.neighbour.size());
  for (int row = 0; row < topology.pointCount(); ++row)
    for (int link = topology.begin[row]; link < topology.begin[row + 1]; ++link) {
      const int a = model.order.outer[row], b = model.order.outer[topology.neighbour[link]];
      const Eigen::Vector3d d = model.rest[b].cast<double>() - model.rest[a].cast<double>();
      model.slack[link] = linkSlack(d, materialOf(a), materialOf(b));
    }
}

}  // namespace pleura
