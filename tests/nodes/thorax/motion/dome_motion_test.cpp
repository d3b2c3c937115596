#include <limits>

#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/dome_motion.h>

namespace pleura {
namespace {

const Eigen::Vector3d kCentre(0.0, 0.0, 0.02);

TEST(DomeMotion, ContractsFromRestToTotalLungCapacityWithoutTurningBack) {
  EXPECT_EQ(diaphragmContraction(0.0), 0.0);
  EXPECT_DOUBLE_EQ(diaphragmContraction(1.0), 1.0);
  for (double i = 0.05; i <= 1.0; i += 0.05)
    EXPECT_GT(diaphragmContraction(i), diaphragmContraction(i - 0.05));
}

TEST(DomeMotion, DescendsAsMeasured) {
  // Boussuges 2009 and Thorax 1994;49:885: quiet 0.8-2.1 cm, deep 5-8.6 cm
  const auto descent = [](double inflation) {
    return kCentre.y() - (tendonMotion({}, kCentre, diaphragmContraction(inflation)) * kCentre).y();
  };
  EXPECT_GT(descent(1.0 / 7.0), 0.008);
  EXPECT_LT(descent(1.0 / 7.0), 0.021);
  EXPECT_GT(descent(1.0), 0.050);
  EXPECT_LT(descent(1.0), 0.086);
}

TEST(DomeMotion, TheBackDescendsMoreThanTheFront) {
  const Eigen::Isometry3d motion = tendonMotion({}, kCentre, 1.0);
  const Eigen::Vector3d front = kCentre + Eigen::Vector3d(0.0, 0.0, 0.04);
  const Eigen::Vector3d back = kCentre - Eigen::Vector3d(0.0, 0.0, 0.04);
  EXPECT_LT((motion * back - back).y(), (motion * front - front).y());
}

TEST(DomeMotion, RefusesWhatIsNotFinite) {
  EXPECT_THROW(diaphragmContraction(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(tendonMotion({}, kCentre, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
