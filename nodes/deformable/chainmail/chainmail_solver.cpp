#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <pleura/nodes/deformable/chainmail/chainmail_range.h>
#include <pleura/nodes/deformable/chainmail/chainmail_solver.h>

// On each axis of the rest frame the limits are difference constraints on the displacements u,
//   u_a - u_b <= slack(a, b),  slack >= 0,
// so what they allow is bounded by shortest paths D over the slack (Cormen et al., Introduction to
// Algorithms, 24.4):
//   low_v = max_i (u_i - D(i, v)),  high_v = min_i (u_i + D(v, i)),  i the driven points,
// and the least moves, clamp(0, low_v, high_v), are allowed all together. Where driven points contradict each
// other low_v > high_v; their middle keeps every link but some of the driven points' own. ChainMail's
// sponsors become a label-correcting search for low and -high, all axes at once; its result is the same
// whatever the order of visits.

namespace pleura {
namespace {

using Displacement = Eigen::Array4f;
using Driven = ChainmailWorkspace::Driven;

ChainmailPull bothWays(const Displacement& u) { return (ChainmailPull() << u, -u).finished(); }

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument("chainmail: " + why); }

void requireRigid(const Eigen::Isometry3d& frame) {
  constexpr double kTolerance = 1e-4;  // a rotation may come from float
  for (const double entry : frame.matrix().reshaped())
    if (!(std::isfinite(entry) && std::abs(entry) <= kChainmailFarthest)) refuse("frame is not finite");
  const Eigen::Matrix3d r = frame.linear();
  if (!(r.transpose() * r).isIdentity(kTolerance) || r.determinant() < 0)
    refuse("frame is more than a rotation and a shift");
}

void requireSound(const ChainmailModel& model, const ChainmailWorkspace& workspace,
                  std::span<const int> driven, std::span<const Eigen::Vector3f> targets,
                  const ChainmailOptions& options, std::span<const Eigen::Vector3f> positions) {
  const std::size_t count = model.rest.size();
  if (workspace.pull.size() != count) refuse("the workspace is for another number of points");
  if (positions.size() != count) refuse("positions must have one entry for each point");
  if (targets.size() != driven.size()) refuse("targets must have one entry for each driven point");
  for (std::size_t k = 0; k < driven.size(); ++k) {
    if (driven[k] < 0 || driven[k] >= model.topology.pointCount())
      refuse("driven point " + std::to_string(driven[k]) + " is out of range");
    requireInChainmailRange("the target of point", driven[k], targets[k]);
  }
  if (options.smoothingSweeps < 0) refuse("smoothingSweeps is negative");
  requireRigid(options.frame);
}

// Sorted by index, so that nothing that follows depends on the order they came in.
void listDriven(const ChainmailModel& model, ChainmailWorkspace& w, std::span<const int> driven,
                std::span<const Eigen::Vector3f> targets, const Eigen::Isometry3d& frame) {
  const Eigen::Isometry3d toRest = frame.inverse();
  w.driven.clear();
  for (std::size_t k = 0; k < driven.size(); ++k) {
    const Eigen::Vector3d u = toRest * targets[k].cast<double>() - model.rest[driven[k]].cast<double>();
    w.driven.push_back(
        {model.order.inner[driven[k]], static_cast<int>(k), Displacement(u.x(), u.y(), u.z(), 0)});
  }
  std::sort(w.driven.begin(), w.driven.end(),
            [](const Driven& a, const Driven& b) { return a.point < b.point; });
  for (std::size_t k = 1; k < w.driven.size(); ++k)
    if (w.driven[k - 1].point == w.driven[k].point &&
        targets[w.driven[k - 1].source] != targets[w.driven[k].source])
      refuse("driven point " + std::to_string(driven[w.driven[k].source]) + " has two different targets");
}

void enqueue(ChainmailWorkspace& w, int point) {
  if (w.isQueued[point]) return;
  w.isQueued[point] = 1;
  w.queue[w.tail] = point;
  if (++w.tail == static_cast<int>(w.queue.size())) w.tail = 0;
}

int dequeue(ChainmailWorkspace& w) {
  const int point = w.queue[w.head];
  w.isQueued[point] = 0;
  if (++w.head == static_cast<int>(w.queue.size())) w.head = 0;
  return point;
}

// What the sums of a solve may be off by.
float roundingOf(const ChainmailWorkspace& w) {
  float largest = 0;
  for (const Driven& d : w.driven) largest = std::max(largest, d.u.abs().maxCoeff());
  return 1e-6f * largest;
}

// Makes the point go at least as far as asked, each way, and ask its own neighbours if that moved it.
void pullPoint(ChainmailWorkspace& w, int point, const ChainmailPull& asked) {
  ChainmailPull& pull = w.pull[point];
  const ChainmailPull raised = pull.max(asked);
  if ((raised - pull).sum() == 0) return;
  pull = raised;
  if (!w.isMoved[point]) {
    w.isMoved[point] = 1;
    w.moved.push_back(point);
  }
  enqueue(w, point);
}

// Region growing: pull_b = max(pull_b, pull_a - slack(a, b)) until nothing changes. Returns the number of
// visits.
int growRegion(const ChainmailModel& model, ChainmailWorkspace& w) {
  int visits = 0;
  for (; w.head != w.tail; ++visits) {
    const int a = dequeue(w);
    const ChainmailPull pull = w.pull[a];
    const int end = model.topology.begin[a + 1];
    for (int link = model.topology.begin[a]; link < end; ++link)
      pullPoint(w, model.topology.neighbour[link], pull - model.slack[link]);
  }
  return visits;
}

ChainmailPull beyondLimits(const ChainmailModel& model, const ChainmailWorkspace& w, int a, int link) {
  return w.pull[a] - w.pull[model.topology.neighbour[link]] - model.slack[link];
}

float worstBeyondLimits(const ChainmailModel& model, const ChainmailWorkspace& w, int a) {
  ChainmailPull worst = ChainmailPull::Zero();
  const int end = model.topology.begin[a + 1];
  for (int link = model.topology.begin[a]; link < end; ++link)
    worst = worst.max(beyondLimits(model, w, a, link));
  return worst.maxCoeff();
}

ChainmailPull opposite(const ChainmailPull& p) {
  return (ChainmailPull() << p.tail<4>(), p.head<4>()).finished();
}

// From (max(low, 0), max(-high, 0)) to (u, -u), but to (low, -high) where both pull. Returns whether any do.
bool closeBounds(ChainmailWorkspace& w) {
  float both = 0;
  for (const int point : w.moved) {
    const ChainmailPull pull = w.pull[point], back = opposite(pull), least = pull.min(back);
    w.pull[point] = (least > 0).select(pull, pull - back);
    both = std::max(both, least.maxCoeff());
  }
  return both > 0;
}

// What asks for more after closing meets a bound of the other side. Growing on from there gives low and -high
// in full wherever low > high; those points take the middle. Returns whether there are such.
bool settleContradictions(const ChainmailModel& model, ChainmailWorkspace& w, float rounding, int& visits) {
  const bool pullBoth = closeBounds(w);
  for (const Driven& d : w.driven)
    if ((bothWays(d.u) - w.pull[d.point]).maxCoeff() > rounding) pullPoint(w, d.point, bothWays(d.u));
  for (const int point : w.moved)
    if (worstBeyondLimits(model, w, point) > rounding) enqueue(w, point);
  if (!pullBoth && w.head == w.tail) return false;
  visits += growRegion(model, w);
  for (const int point : w.moved) w.pull[point] = 0.5f * w.pull[point] - 0.5f * opposite(w.pull[point]);
  return true;
}

// u_v = mean of its neighbours' u, cut to  u_n - slack <= u_v <= u_n + slack  of each; left alone where there
// is no such u_v.
void smoothPoint(const ChainmailModel& model, ChainmailWorkspace& w, int v) {
  const int begin = model.topology.begin[v], end = model.topology.begin[v + 1];
  if (begin == end) return;
  ChainmailPull ceiling = ChainmailPull::Constant(kChainmailFarthest);  // of (u, -u)
  Displacement sum = Displacement::Zero();
  for (int link = begin; link < end; ++link) {
    const ChainmailPull& pull = w.pull[model.topology.neighbour[link]];
    ceiling = ceiling.min(pull + model.slack[link]);
    sum += pull.head<4>();
  }
  const Displacement high = ceiling.head<4>(), low = -ceiling.tail<4>();
  const Displacement cut = (sum / static_cast<float>(end - begin)).min(high).max(low);
  w.pull[v] = bothWays((low <= high).select(cut, w.pull[v].head<4>()));
}

void smooth(const ChainmailModel& model, ChainmailWorkspace& w, int sweeps) {
  for (const Driven& d : w.driven) w.isDriven[d.point] = 1;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const int point : w.moved)
      if (!w.isDriven[point]) smoothPoint(model, w, point);
  for (const Driven& d : w.driven) w.isDriven[d.point] = 0;
}

// Each link of a moved point once; a link between two that rest is at rest.
void countViolations(const ChainmailModel& model, const ChainmailWorkspace& w, float rounding,
                     ChainmailReport& report) {
  for (const int a : w.moved) {
    const float worst = worstBeyondLimits(model, w, a);
    if (worst <= rounding) continue;
    report.worstViolation = std::max(report.worstViolation, worst);
    for (int link = model.topology.begin[a]; link < model.topology.begin[a + 1]; ++link) {
      const int b = model.topology.neighbour[link];
      const bool isCounted = b < a && w.isMoved[b];
      if (!isCounted && beyondLimits(model, w, a, link).maxCoeff() > rounding) ++report.violatedLinks;
    }
  }
}

// Turns about a point of the body, so that float serves at any distance from the origin.
void carry(const Eigen::Isometry3d& frame, std::span<Eigen::Vector3f> positions,
           const Eigen::Vector3f& centre) {
  const Eigen::Matrix3f rotation = frame.linear().cast<float>();
  const Eigen::Vector3f carried = (frame * centre.cast<double>()).cast<float>();
  for (Eigen::Vector3f& position : positions) position = rotation * (position - centre) + carried;
}

void place(const ChainmailModel& model, const ChainmailWorkspace& w, const Eigen::Isometry3d& frame,
           std::span<const Eigen::Vector3f> targets, std::span<Eigen::Vector3f> positions) {
  if (positions.empty()) return;
  std::copy(model.rest.begin(), model.rest.end(), positions.begin());
  for (const int point : w.moved) positions[model.order.outer[point]] += w.pull[point].head<3>().matrix();
  if (frame.matrix() != Eigen::Matrix4d::Identity()) carry(frame, positions, model.rest.front());
  for (const Driven& d : w.driven) positions[model.order.outer[d.point]] = targets[d.source];
}

void clear(ChainmailWorkspace& w) {
  for (const int point : w.moved) {
    w.pull[point].setZero();
    w.isMoved[point] = 0;
  }
  for (const Driven& d : w.driven) w.pull[d.point].setZero();
  w.moved.clear();
}

}  // namespace

ChainmailReport solveChainmail(const ChainmailModel& model, ChainmailWorkspace& workspace,
                               std::span<const int> driven, std::span<const Eigen::Vector3f> targets,
                               const ChainmailOptions& options, std::span<Eigen::Vector3f> positions) {
  requireSound(model, workspace, driven, targets, options, positions);
  listDriven(model, workspace, driven, targets, options.frame);
  const float rounding = roundingOf(workspace);
  ChainmailReport report;
  for (const Driven& d : workspace.driven) pullPoint(workspace, d.point, bothWays(d.u));
  report.visits = growRegion(model, workspace);
  const bool isContradictory = settleContradictions(model, workspace, rounding, report.visits);
  for (const Driven& d : workspace.driven) workspace.pull[d.point] = bothWays(d.u);
  report.movedPoints = static_cast<int>(workspace.moved.size());
  smooth(model, workspace, options.smoothingSweeps);
  if (isContradictory || options.smoothingSweeps > 0) countViolations(model, workspace, rounding, report);
  place(model, workspace, options.frame, targets, positions);
  clear(workspace);
  return report;
}

}  // namespace pleura
