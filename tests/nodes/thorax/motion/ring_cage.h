#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <pleura/nodes/thorax/motion/pleural_wall.h>

namespace pleura {

/// A cage that can be reckoned by hand: six level rings of bone, 30 mm apart about the vertical axis, each a
/// torus of 100 mm radius and 5 mm thickness. Ring k is body k.
struct RingCage {
  static constexpr int kRings = 6;
  static constexpr float kRadius = 0.1f;
  static constexpr float kThickness = 0.005f;
  static constexpr float kApart = 0.03f;

  std::array<TriangleMesh, kRings> rings;
  std::vector<WallBody> bodies;
  PleuralWall wall;

  RingCage() {
    for (int k = 0; k < kRings; ++k) {
      rings[static_cast<std::size_t>(k)] = torus(heightOf(k));
      const TriangleMesh& mesh = rings[static_cast<std::size_t>(k)];
      bodies.push_back({&mesh, std::vector<BodyWeights>(mesh.points.size(), rigidWith(k))});
    }
    wall = buildPleuralWall(hemithoraxAxis({0.0, -0.1, 0.0}, {0.0, 0.1, 0.0}, 1.0), bodies, 0.11);
  }
  RingCage(const RingCage&) = delete;

  static float heightOf(int ring) { return kApart * (2.5f - static_cast<float>(ring)); }

  static TriangleMesh torus(float height) {
    constexpr int kAround = 120;
    constexpr int kAcross = 16;
    TriangleMesh mesh;
    for (int i = 0; i < kAround; ++i) {
      for (int j = 0; j < kAcross; ++j) {
        const float a = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kAround;
        const float b = 2.0f * std::numbers::pi_v<float> * static_cast<float>(j) / kAcross;
        const float r = kRadius + kThickness * std::cos(b);
        mesh.points.emplace_back(r * std::cos(a), height + kThickness * std::sin(b), r * std::sin(a));
        const auto at = [&](int u, int v) { return u % kAround * kAcross + v % kAcross; };
        mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
        mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
      }
    }
    return mesh;
  }

  /// Displacements that lift every ring by `lift` [m].
  static std::array<BodyDisplacement, kRings> lifted(float lift) {
    std::array<BodyDisplacement, kRings> displacements;
    displacements.fill(BodyDisplacement::Zero());
    for (BodyDisplacement& d : displacements) d(1, 3) = lift;
    return displacements;
  }
};

}  // namespace pleura
