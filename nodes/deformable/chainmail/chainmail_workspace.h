#pragma once

#include <cstdint>
#include <vector>

#include <pleura/nodes/deformable/chainmail/chainmail_model.h>

namespace pleura {

/// The memory of a solve, allocated once. Every solve leaves `pull` zero and the flags and the queue empty,
/// at a cost of the points it moved and not of all. Points have the model's inner numbers here.
struct ChainmailWorkspace {
  explicit ChainmailWorkspace(int pointCount);

  struct Driven {
    int point;
    int source;        // its place in the caller's list
    Eigen::Array4f u;  // displacement in the rest frame [m], then a blank
  };

  std::vector<ChainmailPull> pull;     // how far each point must go, each way [m]
  std::vector<std::uint8_t> isMoved;   // whether it is in `moved`
  std::vector<std::uint8_t> isQueued;  // whether it is in `queue`
  std::vector<std::uint8_t> isDriven;
  std::vector<int> moved;  // the points pulled, in order of arrival
  std::vector<int> queue;  // a ring of pointCount + 1 places
  int head = 0;
  int tail = 0;
  std::vector<Driven> driven;  // by index
};

}  // namespace pleura
