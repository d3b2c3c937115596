#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/haptics/contact/four_boxes.h>

namespace pleura::haptics {

/// What stays of a touchable surface while it deforms: its triangles and the shape of the tree of boxes about
/// them. Immutable, shared by all its frames and both threads.
class TouchMesh {
 public:
  /// Throws std::invalid_argument on no triangles, indices out of range and points that are not finite.
  /// Triangles without area are left out. Points at one place count as one where the surface's sides are
  /// told. O(n log n).
  TouchMesh(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles);

  std::size_t pointCount() const { return welded_.size(); }
  /// In the tree's order: those that lie together are together in memory.
  std::span<const Eigen::Vector3i> triangles() const { return triangles_; }
  /// Different for every mesh of the process.
  std::uint64_t serial() const { return serial_; }

  /// Every edge has a triangle on either side: nobody comes to the back without going through.
  bool isClosed() const { return closed_; }

  /// The triangles about a point.
  std::span<const int> incident(int point) const;
  /// The same for two points at one place.
  int welded(int point) const { return welded_[point]; }

  /// Up to four children a node, each a node or kLeafSize triangles at most; parents before children.
  static constexpr int kLeafSize = 8;
  struct Child {
    int first;
    int count;  // of triangles, triangles()[first] and on; 0: `first` is a node
  };
  struct Node {
    std::array<Child, 4> children;
    int childCount = 0;
  };
  std::span<const Node> nodes() const { return nodes_; }

 private:
  void weld(std::span<const Eigen::Vector3f> points);
  void findIncident();
  bool everyEdgeHasTwoSides() const;
  void sortIntoTree(std::span<const Eigen::Vector3f> points);
  Child build(std::span<const Eigen::Vector3f> centroids, std::span<int> order, int begin, int end);

  std::vector<Eigen::Vector3i> triangles_;
  std::vector<int> welded_;         // the first point at the same place
  std::vector<int> incidentBegin_;  // of welded points
  std::vector<int> incident_;
  std::vector<Node> nodes_;
  std::uint64_t serial_;
  bool closed_ = false;
};

/// The points of a surface at one moment [m], and the tree's boxes about them.
struct TouchMeshFrame {
  std::vector<Eigen::Array4f> points;  // one load each; the fourth number is 0
  std::vector<FourBoxes> boxes;        // about the children of each of the mesh's nodes
  std::uint64_t serial = 0;            // different after every fit of the process

  /// As many points as the mesh has. Linear; allocates only when the frame served a smaller mesh before.
  /// Throws std::invalid_argument on points that are not finite or of another number, the frame untouched.
  void fit(const TouchMesh& mesh, std::span<const Eigen::Vector3f> moved);
};

}  // namespace pleura::haptics
