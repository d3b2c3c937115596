#include <numeric>
#include <random>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/block_cholesky.h>

namespace pleura {
namespace {

struct System {
  BlockPattern pattern;
  BlockValues values;
  Eigen::MatrixXd dense;
};

// Nodes 0 to n - 1 coupled at random, in two parts that know nothing of each other; positive definite.
System randomSystem(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<int> begin{0}, node;
  for (int g = 0; g < 2 * n; ++g) {
    const int half = n / 2, part = g % 2 ? half : 0, size = g % 2 ? n - half : half;
    for (int k = 0; k < 3; ++k)
      node.push_back(part + static_cast<int>(random() % static_cast<unsigned>(size)));
    begin.push_back(static_cast<int>(node.size()));
  }
  System system{makeBlockPattern(n, begin, node), {}, Eigen::MatrixXd::Zero(3 * n, 3 * n)};
  std::uniform_real_distribution<double> uniform(-1, 1);
  system.values.assign(static_cast<std::size_t>(system.pattern.slotCount()), Eigen::Matrix3d::Zero());
  for (std::size_t g = 0; g + 1 < begin.size(); ++g) {
    const int i = node[begin[g]], j = node[static_cast<std::size_t>(begin[g]) + 1];
    const Eigen::Matrix3d A = Eigen::Matrix3d::NullaryExpr([&] { return uniform(random); });
    const Eigen::Matrix3d B = Eigen::Matrix3d::NullaryExpr([&] { return uniform(random); });
    addBlock(system.values, system.pattern.slot(i, i), A * A.transpose());
    addBlock(system.values, system.pattern.slot(j, j), B * B.transpose());
    system.dense.block<3, 3>(3 * i, 3 * i) += A * A.transpose();
    system.dense.block<3, 3>(3 * j, 3 * j) += B * B.transpose();
    if (i == j) continue;
    addBlock(system.values, system.pattern.slot(i, j), A * B.transpose());
    system.dense.block<3, 3>(3 * i, 3 * j) += A * B.transpose();
    system.dense.block<3, 3>(3 * j, 3 * i) += B * A.transpose();
  }
  for (int i = 0; i < n; ++i) {
    addBlock(system.values, system.pattern.slot(i, i), 0.1 * Eigen::Matrix3d::Identity());
    system.dense.block<3, 3>(3 * i, 3 * i) += 0.1 * Eigen::Matrix3d::Identity();
  }
  return system;
}

NodeVectors randomVectors(int n) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  NodeVectors x(static_cast<std::size_t>(n));
  for (auto& v : x) v = Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
  return x;
}

TEST(BlockMatrix, MultipliesAsTheDenseOne) {
  const System system = randomSystem(30, 1);
  const NodeVectors x = randomVectors(30);
  NodeVectors y(x.size());
  multiply(system.pattern, system.values, x, y);
  EXPECT_LT((flat(y) - system.dense * flat(x)).norm(), 1e-12);
}

TEST(BlockCholesky, SolvesAsTheDenseOne) {
  for (const int n : {2, 3, 10, 60, 200}) {
    const System system = randomSystem(n, static_cast<unsigned>(n));
    std::vector<int> unknowns;
    for (int i = 0; i < n; ++i)
      if (i % 5 != 1) unknowns.push_back(i);
    BlockCholesky factor(system.pattern, unknowns);
    ASSERT_TRUE(factor.factorise(system.pattern, system.values));
    ASSERT_TRUE(factor.factorise(system.pattern, system.values)) << "again";
    const NodeVectors b = randomVectors(n);
    NodeVectors x(b.size());
    factor.solve(b, x);
    Eigen::MatrixXd chosen = system.dense;
    Eigen::VectorXd right = flat(b);
    for (int i = 0; i < n; ++i)
      if (i % 5 == 1)
        for (int k = 3 * i; k < 3 * i + 3; ++k) {
          chosen.row(k).setZero();
          chosen.col(k).setZero();
          chosen(k, k) = 1;
          right[k] = 0;
        }
    EXPECT_LT((flat(x) - chosen.llt().solve(right)).norm(), 1e-10) << n;
  }
}

TEST(BlockCholesky, ToldOfNoUnknownsAndOfASingularMatrix) {
  System system = randomSystem(20, 4);
  BlockCholesky none(system.pattern, {});
  EXPECT_TRUE(none.factorise(system.pattern, system.values));
  NodeVectors x = randomVectors(20);
  none.solve(x, x);
  EXPECT_EQ(flat(x).norm(), 0);

  // Springs between neighbours along a line, held nowhere.
  std::vector<int> begin{0}, node, all;
  for (int i = 0; i < 20; ++i) {
    all.push_back(i);
    if (i == 19) break;
    node.insert(node.end(), {i, i + 1});
    begin.push_back(2 * (i + 1));
  }
  const BlockPattern line = makeBlockPattern(20, begin, node);
  BlockValues values(static_cast<std::size_t>(line.slotCount()), Eigen::Matrix3d::Zero());
  const Eigen::Matrix3d k = Eigen::Matrix3d::Identity() / 3;
  for (int i = 0; i < 19; ++i) {
    addBlock(values, line.slot(i, i), k);
    addBlock(values, line.slot(i + 1, i + 1), k);
    addBlock(values, line.slot(i, i + 1), -k);
  }
  BlockCholesky factor(line, all);
  EXPECT_FALSE(factor.factorise(line, values));
  addBlock(values, line.slot(0, 0), 1e-6 * k);
  EXPECT_TRUE(factor.factorise(line, values));
}

// Of (1, -c; -c, 1) the second pivot is 1 - c^2.
TEST(BlockCholesky, IsSingularFromAPivotOf1e14th) {
  const BlockPattern pair = makeBlockPattern(2, std::vector{0, 2}, std::vector{0, 1});
  const auto isRegular = [&](double pivot) {
    BlockValues values(3, Eigen::Matrix3d::Identity());
    values[1] *= -(1 - pivot / 2);
    return BlockCholesky(pair, std::vector{0, 1}).factorise(pair, values);
  };
  EXPECT_TRUE(isRegular(1e-13));
  EXPECT_FALSE(isRegular(4e-15));
}

TEST(BlockCholesky, RefusesAFactorThatWouldBeTooLarge) {
  const System system = randomSystem(200, 5);
  std::vector<int> all(200);
  std::iota(all.begin(), all.end(), 0);
  const std::size_t size = BlockCholesky(system.pattern, all).factorSize();
  EXPECT_NO_THROW(BlockCholesky(system.pattern, all, size));
  EXPECT_THROW(BlockCholesky(system.pattern, all, size / 2), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
