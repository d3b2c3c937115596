#pragma once

#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/lung/planar/planar_parameters.h>

namespace pleura::planar {

/// The wall of one pleural space: a closed polyline that moves linearly with the chest's coordinates,
/// w_k = rest_k + diaphragm_k q_0 + chestWall_k q_1.
struct ChestOutline {
  std::vector<Eigen::Vector2d> rest;       // [m], around the cavity, the first at the hilum
  std::vector<Eigen::Vector2d> diaphragm;  // dw / dq_0
  std::vector<Eigen::Vector2d> chestWall;  // dw / dq_1
  double orientation = 1;                  // 1: counter-clockwise, -1: clockwise
  int woundBegin = 0, woundEnd = 0;        // the wound opens the segments from point woundBegin to woundEnd

  Eigen::Vector2d at(std::size_t k, const Eigen::Vector2d& q) const {
    return rest[k] + q[0] * diaphragm[k] + q[1] * chestWall[k];
  }
};

/// The lung at its natural, unstretched shape.
struct LungMesh {
  std::vector<Eigen::Vector2d> points;     // [m]; the outline first, in the wall's direction, from the hilum
  std::vector<Eigen::Vector3i> triangles;  // counter-clockwise
  int outlineCount = 0;
  int heldCount = 0;  // the hilum: outline points -heldCount .. heldCount (round the ring) do not move
};

/// A side of the chest as flat arrays, for the solver and for drawing.
struct Hemithorax {
  ChestOutline wall;
  LungMesh lung;
  // The intrapleural space: a ring between the outlines, as triangles over the lung's outline points followed
  // by the wall's; counter-clockwise. The sum of their areas is that of the wall less that of the lung.
  std::vector<Eigen::Vector3i> strip;

  /// Points of the wall to be drawn as one line: all of them and the first again, or, with a wound, those
  /// from its end round to its beginning.
  std::vector<int> wallLine(bool isWounded) const;
};

/// Pure: the same shape gives the same bits. Throws std::invalid_argument when a parameter is outside the
/// range its comment says, or when they make no cavity that holds a mesh.
Hemithorax makeHemithorax(const HemithoraxShape& shape);

}  // namespace pleura::planar
