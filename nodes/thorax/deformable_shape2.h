#pragma once

#include <array>
#include <memory>
#include <vector>

#include <pleura/fields/joined_field.h>
#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/deformable/deformer_node.h>
#include <pleura/nodes/deformable/job.h>
#include <pleura/nodes/standard/shape/touchable_shape.h>
#include <pleura/nodes/standard/shape/x3d_shape_node.h>

namespace pleura {

/// A shape that deforms because some of its points are moved: an organ. Its geometry is an IndexedTriangleSet
/// or IndexedFaceSet with a Coordinate, which shows `touchedCoord`. Nobody looks, nothing is computed. Organs
/// that have begun are solved side by side, in as many threads as there are, to the same bits.
class DeformableShape2 : public X3DShapeNode, public TouchableShape {
 public:
  TypedSFNode<DeformerNode> deformer;
  MFVec3f origCoord;
  MFInt32 rigid_points;

  JoinedField<MFInt32> contactIndex;
  JoinedField<MFVec3f> contactPoint;

  class Deformed : public TypedField<MFVec3f, AnyNumber<Any<MFVec3f, MFInt32, SFNode, SFMatrix4f, SFVec3f,
                                                            SFFloat, SFInt32, SFBool, SFString, SFTime>>> {
    void update() override { static_cast<DeformableShape2*>(getOwner())->deform(value); }
  };
  Deformed deformedCoord;

  class Touched : public TypedField<MFVec3f, Types<MFVec3f, MFVec3f, MFVec3f, MFFloat>> {
    void update() override;
  };
  Touched touchedCoord;

  class Volume : public TypedField<SFFloat, Types<MFVec3f>> {
    void update() override;
  };
  Volume volume;

  class Top : public TypedField<SFFloat, Types<MFVec3f>> {
    void update() override;
  };
  Top top;

  ~DeformableShape2() override;

  void begin() override;

  /// Leaves the points that nothing moves to that deformer from now on.
  void deformBy(const NodePtr& chosen);

  /// The rest shape with its triangles.
  const TriangleMesh& rest();

  MFVec3f& untouchedPoints() override { return deformedCoord; }
  std::span<const Eigen::Vector3i> untouchedTriangles() override { return rest().triangles; }

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
  /// Says by drive() where points are moved to; called before each solve.
  virtual void gatherContacts();
  /// Moves a point of the surface; of two targets for one point the later counts.
  void drive(int point, const Vec3f& target);
  /// The points that keep their places to one another.
  virtual const std::vector<int>& rigidPoints() { return rigid_points.getValue(); }

 private:
  /// Fields that the deformer's answer depends on are inputs of the shape's, those of a later deformer too.
  /// Throws std::invalid_argument where it serves another shape.
  void hearDeformer();
  void serveBy(std::shared_ptr<DeformerNode> solver);
  void deform(std::vector<Vec3f>& positions);
  /// Brings all that the shape depends on up to date; grows with each change of it.
  std::uint64_t inputStamp();
  /// Gathers what the answer is made of, for these inputs.
  void prepare(std::uint64_t inputs);
  void takeRest();
  bool givesWay();
  /// Grows when the deformer has to be given the shape at rest: another one, or, where it has refused it,
  /// once one of its own fields has changed.
  std::uint64_t restStamp(DeformerNode& solver);
  /// Every point is held: there is nothing left for the deformer to do.
  void takeTargets(std::vector<Vec3f>& positions);
  void takeSolved(std::vector<Vec3f>& positions);

  TriangleMesh rest_;
  std::array<std::uint64_t, 2> meshStamps_{};
  std::uint64_t restStamp_ = 0;
  std::vector<int> restRigid_;
  bool usable_ = false;
  std::vector<int> driven_;
  std::vector<Vec3f> targets_;
  std::vector<int> slot_;  // of each point in driven_, -1: none

  enum class Answer { none, targets, solved };
  Answer answer_ = Answer::none;           // what prepare() found to be done
  std::uint64_t preparedFor_ = 0;          // inputs; 0: none
  std::shared_ptr<DeformerNode> serving_;  // that has taken the shape at rest
  std::vector<Vec3f> solved_;
  Job solve_{[this] { serving_->solve(driven_, targets_, solved_); }};  // last: it uses all the others
};

}  // namespace pleura
