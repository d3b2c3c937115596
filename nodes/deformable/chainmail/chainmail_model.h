#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/chainmail/chainmail_order.h>
#include <pleura/nodes/deformable/chainmail/chainmail_topology.h>

namespace pleura {

/// How much a link gives, as ratios of its rest offset; the defaults are those of the ChainmailDeformer node.
struct ChainmailMaterial {
  float compression = 0.33333f;  // 0 to 1: how short an offset may become
  float stretch = 1.25f;         // 1 or more: how long
  float shear = 0.25f;           // 0 or more: how far aside, for each length across
};
inline constexpr ChainmailMaterial kRigid{1, 1, 0};

/// One number for each way a point can be pulled: along +x +y +z, a blank, along -x -y -z, a blank [m].
using ChainmailPull = Eigen::Array<float, 8, 1>;

/// An organ ready to be solved for: what depends on rest shape and material alone.
struct ChainmailModel {
  std::vector<Eigen::Vector3f> rest;  // [m], in the rest frame, as the caller numbers the points
  ChainmailOrder order;               // from and to the numbers that what follows uses
  ChainmailTopology topology;
  std::vector<ChainmailPull> slack;  // along topology.neighbour [m]: how far b may lag behind a, each way
};

/// Generalised ChainMail (Li and Brodlie 2003) over these links. A link takes the mean of its ends'
/// materials: it is half the one and half the other, in series. `material` has one entry a point, or one for
/// all. Throws std::invalid_argument unless 0 <= compression <= 1 <= stretch and shear >= 0, all finite.
ChainmailModel makeChainmailModel(std::span<const Eigen::Vector3f> rest, const ChainmailTopology& topology,
                                  std::span<const ChainmailMaterial> material);

/// Gives the model another material; the same rules. On an error the model keeps the material it had.
void setMaterial(ChainmailModel& model, std::span<const ChainmailMaterial> material);

}  // namespace pleura
