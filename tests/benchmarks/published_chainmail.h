#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <span>
#include <vector>

#include <pleura/nodes/deformable/chainmail/chainmail_model.h>

namespace pleura {

/// ChainMail as it was published with the breathing thorax (Jacob 2008), with its faults, to measure against:
/// one first-in first-out pass for each source, each point at most once in it, over boxes along the axes that
/// know the sponsor's material alone; the first source is passed twice and left out of the mean of the
/// passes.
class PublishedChainmail {
 public:
  PublishedChainmail(std::span<const Eigen::Vector3f> rest, const ChainmailTopology& topology,
                     const ChainmailMaterial& material)
      : rest_(rest.begin(), rest.end()), topology_(topology), material_(material), visited_(rest.size()) {}

  void solve(std::span<const int> driven, std::span<const Eigen::Vector3f> targets,
             std::vector<Eigen::Vector3f>& positions) {
    const std::vector<Eigen::Vector3f> start = positions;
    std::vector<Eigen::Vector3f> sum(rest_.size(), Eigen::Vector3f::Zero());
    pass(driven[0], targets[0], start);
    for (std::size_t k = 0; k < driven.size(); ++k) {
      pass(driven[k], targets[k], start);
      if (k == 0) continue;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += pass_[i];
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
      positions[i] = sum[i] / static_cast<float>(driven.size() - 1);
    for (std::size_t k = 0; k < driven.size(); ++k) positions[driven[k]] = targets[k];
  }

 private:
  void pass(int source, const Eigen::Vector3f& target, const std::vector<Eigen::Vector3f>& start) {
    pass_ = start;
    visited_.assign(rest_.size(), 0);
    pass_[source] = target;
    visited_[source] = 1;
    std::deque<int> queue{source};
    for (; !queue.empty(); queue.pop_front()) {
      const int a = queue.front();
      for (int link = topology_.begin[a]; link < topology_.begin[a + 1]; ++link) {
        const int b = topology_.neighbour[link];
        if (visited_[b]) continue;
        visited_[b] = 1;
        if (pullIntoBox(a, b)) queue.push_back(b);
      }
    }
  }

  bool pullIntoBox(int a, int b) {
    const Eigen::Vector3f d = rest_[b] - rest_[a], before = pass_[b];
    for (int axis = 0; axis < 3; ++axis) {
      const float s = material_.shear * (d.cwiseAbs().sum() - std::abs(d[axis]));
      const float nearest =
          d[axis] < 0 ? material_.stretch * d[axis] - s : material_.compression * d[axis] - s;
      const float farthest =
          d[axis] < 0 ? material_.compression * d[axis] + s : material_.stretch * d[axis] + s;
      pass_[b][axis] = std::clamp(pass_[b][axis], pass_[a][axis] + nearest, pass_[a][axis] + farthest);
    }
    return pass_[b] != before;
  }

  std::vector<Eigen::Vector3f> rest_;
  ChainmailTopology topology_;
  ChainmailMaterial material_;
  std::vector<char> visited_;
  std::vector<Eigen::Vector3f> pass_;
};

}  // namespace pleura
