#pragma once

#include <optional>

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/lung/planar/planar_lung_system.h>
#include <pleura/nodes/lung/planar_lung.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// The chest of DeCarlo et al. (1995), in a coronal section: diaphragm and chest wall are its two degrees of
/// freedom, and any number of lungs live in it that know each other by the chest alone. At the start each
/// lung is drawn out of its natural shape by intrapleural pressure. Inhaling is a force, exhaling is none.
/// Goes on with the scene's time when somebody looks.
class PlanarChest : public X3DChildNode {
 public:
  TypedMFNode<PlanarLung> lungs;
  SFVec3f diaphragm;
  SFVec3f chestWall;
  SFFloat thickness;
  SFFloat intrapleuralPressure;
  SFFloat ambientPressure;
  SFVec2f muscleForce;
  SFFloat effort;

  class Coordinate : public TypedField<SFFloat, AnyNumber<SFTime>> {
   public:
    explicit Coordinate(Eigen::Index number) : number_(number) {}

   private:
    void update() override {
      if (auto* system = static_cast<PlanarChest*>(getOwner())->now())
        value = static_cast<float>(system->chest()[number_]);
    }
    Eigen::Index number_;
  };
  Coordinate diaphragmDescent{0};
  Coordinate wallExcursion{1};

  /// At the scene's time; null where the parameters make no chest.
  PlanarLungSystem* now();

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  void begin();
  void tendWounds();
  void advanceTo(Time time);

  std::optional<PlanarLungSystem> system_;
  std::vector<PlanarLung*> members_;
  std::vector<double> pleuralVolume_;  // [m^3] of each lung, at the start
  Time time_ = 0;
  float effort_ = 0;
};

}  // namespace pleura
