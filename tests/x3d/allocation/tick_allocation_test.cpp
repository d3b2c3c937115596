#include <memory>
#include <new>

#include <gtest/gtest.h>

#include <pleura/tests/x3d/allocation/allocations.h>
#include <pleura/tests/x3d/browser/load_scene.h>
#include <pleura/x3d/browser/view/scene_view.h>

namespace pleura {
namespace {

/// A scene that is looked at once a tick, as a picture of it would be drawn, and of which fields are
/// followed.
class Watched {
 public:
  explicit Watched(std::unique_ptr<Scene> scene) : scene_(std::move(scene)) {}
  Scene* operator->() { return scene_.get(); }
  void follow(const char* path) { followed_.push_back(&scene_->field(path)); }

  /// Allocations of `count` ticks, 50 a second.
  std::uint64_t tick(int count) {
    const std::uint64_t before = allocations();
    for (int i = 0; i < count; ++i) {
      scene_->tick(now_ += 0.02);
      view_.update();
      for (Field* field : followed_) field->upToDate();
    }
    return allocations() - before;
  }

 private:
  std::unique_ptr<Scene> scene_;
  SceneView view_{*scene_};
  std::vector<Field*> followed_;
  double now_ = 0;
};

constexpr int kFirst = 5;     // ticks that may allocate what all later ones use again
constexpr int kBreath = 200;  // ticks of a breath, at 15 a minute

Watched thorax() {
  auto scene = std::make_unique<Scene>();
  scene->load(PLEURA_SOURCE_DIR "/scenes/breathing_thorax.x3d");
  Watched watched(std::move(scene));
  for (const char* path : {"BREATH.phase", "BREATH.lungVolume", "BREATH.tidalVolume", "BREATH.domeHeight"})
    watched.follow(path);
  return watched;
}

TEST(Allocations, OfEveryKindAreCounted) {
  const std::uint64_t before = allocations();
  static std::unique_ptr<int> one;  // which no compiler does without
  one = std::make_unique<int>(1);
  EXPECT_EQ(allocations(), before + 1);
  std::vector<Eigen::Vector4d> some(3);
  EXPECT_EQ(allocations(), before + 2);
  Eigen::MatrixXd matrix(one ? 4 : 0, static_cast<int>(some.size()));
  EXPECT_EQ(allocations(), before + 3);
}

TEST(TickAllocatesNothing, OfAThoraxThatBreathes) {
  Watched scene = thorax();
  scene.tick(kFirst);
  EXPECT_EQ(scene.tick(kBreath), 0U);
}

TEST(TickAllocatesNothing, WhileItIsPausedAndOnceItGoesOn) {
  Watched scene = thorax();
  scene.tick(kFirst);
  scene->set("BREATH.paused=true");
  EXPECT_EQ(scene.tick(kBreath), 0U);
  scene->set("BREATH.paused=false");
  EXPECT_EQ(scene.tick(kBreath), 0U);
}

TEST(TickAllocatesNothing, AfterRateDepthAndStyleAreSet) {
  Watched scene = thorax();
  scene.tick(kFirst);
  for (const char* change : {"BREATH.rate=40", "BREATH.depth=1", "BREATH.style=SINUSOID", "BREATH.rate=6"}) {
    scene->set(change);
    EXPECT_EQ(scene.tick(kBreath), 0U) << change;
  }
}

TEST(TickAllocatesNothing, OfTimersAndInterpolators) {
  Watched scene(
      sceneOf("<Transform DEF='T'><Shape><Box/></Shape></Transform>"
              "<Shape><Appearance><Material DEF='M'/></Appearance><IndexedTriangleSet index='0 1 2'>"
              "<Coordinate DEF='C' point='0 0 0 1 0 0 0 1 0'/></IndexedTriangleSet></Shape>"
              "<TimeSensor DEF='CLOCK' loop='true' cycleInterval='0.7'/>"
              "<PositionInterpolator DEF='P' key='0 0.5 1' keyValue='0 0 0 1 2 3 0 0 0'/>"
              "<OrientationInterpolator DEF='O' key='0 1' keyValue='0 1 0 0 0 1 0 3'/>"
              "<ColorInterpolator DEF='K' key='0 1' keyValue='1 0 0 0 1 0'/>"
              "<CoordinateInterpolator DEF='X' key='0 1' keyValue='0 0 0 1 0 0 0 1 0 0 0 1 1 0 1 0 1 1'/>"
              "<ROUTE fromNode='CLOCK' fromField='fraction_changed' toNode='P' toField='set_fraction'/>"
              "<ROUTE fromNode='CLOCK' fromField='fraction_changed' toNode='O' toField='set_fraction'/>"
              "<ROUTE fromNode='CLOCK' fromField='fraction_changed' toNode='K' toField='set_fraction'/>"
              "<ROUTE fromNode='CLOCK' fromField='fraction_changed' toNode='X' toField='set_fraction'/>"
              "<ROUTE fromNode='P' fromField='value_changed' toNode='T' toField='translation'/>"
              "<ROUTE fromNode='O' fromField='value_changed' toNode='T' toField='rotation'/>"
              "<ROUTE fromNode='K' fromField='value_changed' toNode='M' toField='diffuseColor'/>"
              "<ROUTE fromNode='X' fromField='value_changed' toNode='C' toField='point'/>"));
  ASSERT_EQ(scene->diagnostics().all().size(), 0U);
  scene.tick(kFirst);
  EXPECT_EQ(scene.tick(kBreath), 0U);
}

}  // namespace
}  // namespace pleura
