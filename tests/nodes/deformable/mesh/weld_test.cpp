#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/weld.h>

namespace pleura {
namespace {

using Eigen::Vector3f;

/// By its words: the first point that stands for itself and is no farther.
std::vector<int> weldedOneByOne(const std::vector<Vector3f>& points, double distance) {
  std::vector<int> result(points.size());
  std::iota(result.begin(), result.end(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (result[j] != static_cast<int>(j)) continue;
      if ((points[i].cast<double>() - points[j].cast<double>()).norm() > distance) continue;
      result[i] = static_cast<int>(j);
      break;
    }
  return result;
}

TEST(WeldedPoints, AreTheFirstNoFarther) {
  std::mt19937 random(1);
  for (const double distance : {0.0, 1e-3, 0.02, 0.3}) {
    std::uniform_real_distribution<float> anywhere(-1, 1);
    std::uniform_int_distribution<int> grid(-10, 10);
    std::vector<Vector3f> points;
    for (int i = 0; i < 1500; ++i) {
      const float x = anywhere(random), y = anywhere(random), z = anywhere(random);
      // every other on a grid: many at one place, many at equal distances
      points.push_back(i % 2 == 0
                           ? Vector3f(x, y, z)
                           : Vector3f(static_cast<float>(grid(random)), static_cast<float>(grid(random)),
                                      static_cast<float>(grid(random))) /
                                 8);
    }
    points.emplace_back(-0.0F, 0.0F, 0.0F);
    points.emplace_back(0.0F, -0.0F, 0.0F);
    EXPECT_EQ(weldedPoints(points, distance), weldedOneByOne(points, distance)) << distance;
  }
}

TEST(WeldedPoints, LeaveOutWhatIsNotFiniteAndReachFar) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), most = std::numeric_limits<float>::max();
  const std::vector<Vector3f> points{
      {nan, 0, 0}, {nan, 0, 0}, {most, most, most}, {most, most, most}, {-most, 0, 0}};
  for (const double distance : {0.0, 1e-12, 1.0})
    EXPECT_EQ(weldedPoints(points, distance), (std::vector<int>{0, 1, 2, 2, 4})) << distance;
}

}  // namespace
}  // namespace pleura
