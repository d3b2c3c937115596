#include <stdexcept>

#include <pleura/nodes/deformable/chainmail/chainmail_workspace.h>

namespace pleura {

ChainmailWorkspace::ChainmailWorkspace(int pointCount) {
  if (pointCount < 0) throw std::invalid_argument("chainmail: pointCount is negative");
  pull.assign(pointCount, ChainmailPull::Zero());
  for (auto* flags : {&isMoved, &isQueued, &isDriven}) flags->assign(pointCount, 0);
  moved.reserve(pointCount);
  queue.resize(pointCount + 1);
  driven.reserve(pointCount);
}

}  // namespace pleura
