#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/x3d/play/played_scene.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura {
namespace {

using testing::HasSubstr;

/// Left, a rib breathes quickly and deeply; right, a metronome never stops: it shows that frames are drawn.
constexpr const char* kBreathing = R"(<Scene><ImportLibrary library='"thorax"'/>
  <OrthoViewpoint position='0 0 5' fieldOfView='-2 -1.5 2 1.5'/>
  <Respiration DEF='BREATH' rate='30' depth='0.5' style='SINUSOID'/>
  <KeySensor DEF='KEYS'/>
  <Transform translation='-1 0 0'>
    <RotTransform DEF='RIB' angles='1 1 1' center='0 0 0'><Shape><Box size='1 0.2 0.4'/></Shape></RotTransform>
  </Transform>
  <TimeSensor DEF='CLOCK' cycleInterval='1' loop='true'/>
  <PositionInterpolator DEF='SWING' key='0 0.5 1' keyValue='0.5 0 0  1.5 0 0  0.5 0 0'/>
  <Transform DEF='METRONOME'><Shape><Box size='0.2 1 0.2'/></Shape></Transform>
  <ROUTE fromNode='KEYS' fromField='keyPress' toNode='BREATH' toField='keyPress'/>
  <ROUTE fromNode='BREATH' fromField='inflation' toNode='RIB' toField='inflation'/>
  <ROUTE fromNode='CLOCK' fromField='fraction_changed' toNode='SWING' toField='set_fraction'/>
  <ROUTE fromNode='SWING' fromField='value_changed' toNode='METRONOME' toField='translation'/>
</Scene>)";

/// A white plate, seen from the front, from the side and from afar.
constexpr const char* kPlate = R"(<Scene>
  <Viewpoint DEF='Z_FRONT' position='0 0 5'/>
  <Viewpoint DEF='Y_SIDE' position='5 0 0' orientation='0 1 0 1.5708'/>
  <Transform translation='0 0 10'><Viewpoint DEF='X_AFAR' position='0 0 10'/></Transform>
  <Shape><Appearance><Material emissiveColor='1 1 1'/></Appearance><Box size='2 2 0.2'/></Shape>
</Scene>)";

Picture left(const Picture& of) { return of.columns(0, of.width / 2); }
Picture right(const Picture& of) { return of.columns(of.width / 2, of.width); }

bool showsOtherThan(PlayedScene& played, const Picture& before) {
  return eventually([&] { return played.picture() != before; });
}

/// Where in the picture the bright pixels are, and how many.
struct Bright {
  int count = 0;
  double x = 0, y = 0;  // their mean [pixel from the top left]
};

Bright brightOf(const Picture& picture) {
  Bright bright;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if ((picture.pixels[static_cast<std::size_t>(y) * picture.width + x] & 0xFF) > 0x80) {
        ++bright.count;
        bright.x += x;
        bright.y += y;
      }
  bright.x /= std::max(1, bright.count);
  bright.y /= std::max(1, bright.count);
  return bright;
}

class Playing : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(Playing, TheThoraxBreathesPausesAndResumes) {
  PlayedScene played(PLEURA_SOURCE_DIR "/scenes/breathing_thorax.x3d");
  EXPECT_TRUE(showsOtherThan(played, played.picture()));
  EXPECT_TRUE(eventually([&] { return played.title().ends_with(" - 15 breaths/min, depth 0.14"); }));
  played.press("p");
  EXPECT_TRUE(eventually([&] { return played.title().ends_with(", paused"); })) << played.title();
  const Picture paused = played.picture();
  played.press("p");
  EXPECT_TRUE(showsOtherThan(played, paused));
  played.close();
  EXPECT_EQ(played.exitStatus(), 0);
}

TEST_F(Playing, WhatIsPausedStandsStillWhileFramesGoOn) {
  PlayedScene played(folder_.write("breathing.x3d", kBreathing));
  const Picture start = left(played.picture());
  EXPECT_TRUE(eventually([&] { return left(played.picture()) != start; }));
  played.press("p");
  ASSERT_TRUE(eventually([&] { return played.title().ends_with(", paused"); })) << played.title();
  const Picture paused = played.picture();
  Picture last = paused;
  for (int frame = 1; frame <= 10; ++frame) {
    ASSERT_TRUE(eventually([&] { return right(played.picture()) != right(last); }));
    last = played.picture();
    EXPECT_TRUE(left(last) == left(paused)) << "in frame " << frame;
  }
  played.press("p");
  EXPECT_TRUE(eventually([&] { return left(played.picture()) != left(paused); }));
}

TEST_F(Playing, ArrowsChangeRateAndDepth) {
  PlayedScene played(folder_.write("breathing.x3d", kBreathing));
  const auto shows = [&](const char* breath) {
    return eventually([&] { return played.title().ends_with(breath); });
  };
  EXPECT_TRUE(shows(" - 30 breaths/min, depth 0.50"));
  played.press("Right");
  EXPECT_TRUE(shows(" - 31 breaths/min, depth 0.50"));
  played.press("Left Left");
  EXPECT_TRUE(shows(" - 29 breaths/min, depth 0.50"));
  played.press("Up");
  EXPECT_TRUE(shows(" - 29 breaths/min, depth 0.54"));
  played.press("Down Down");
  EXPECT_TRUE(shows(" - 29 breaths/min, depth 0.46"));
}

TEST_F(Playing, TheMouseOrbitsPansAndZoomsAndHomeGoesBack) {
  PlayedScene played(folder_.write("plate.x3d", kPlate));
  ASSERT_TRUE(eventually([&] { return brightOf(played.picture()).count > 0; }));
  const Picture rest = played.picture();
  const Bright front = brightOf(rest);
  const auto becomes = [&](const auto& isSo) {
    return eventually([&] { return isSo(brightOf(played.picture())); });
  };
  const auto goesHome = [&] {
    played.press("Home");
    return eventually([&] { return played.picture() == rest; });
  };

  played.drag(1, 120, 0);  // a quarter turn: the plate's edge
  EXPECT_TRUE(becomes([&](const Bright& b) {
    return b.count > 0 && b.count < front.count / 4 && std::abs(b.x - front.x) < 2;
  }));
  EXPECT_TRUE(goesHome());

  played.drag(3, 30, 20);
  EXPECT_TRUE(becomes(
      [&](const Bright& b) { return std::abs(b.x - front.x - 30) < 2 && std::abs(b.y - front.y - 20) < 2; }));
  EXPECT_TRUE(goesHome());

  played.turnWheel(-2);
  EXPECT_TRUE(becomes([&](const Bright& b) { return b.count > front.count * 1.3; }));
  EXPECT_TRUE(goesHome());
  played.turnWheel(2);
  EXPECT_TRUE(becomes([&](const Bright& b) { return b.count > 0 && b.count < front.count * 0.8; }));
  EXPECT_TRUE(goesHome());
}

TEST_F(Playing, PageKeysGoThroughTheViewpointsInTheScenesOrder) {
  PlayedScene played(folder_.write("plate.x3d", kPlate));
  ASSERT_TRUE(eventually([&] { return brightOf(played.picture()).count > 0; }));
  const Picture front = played.picture();
  const int frontal = brightOf(front).count;
  const auto becomes = [&](int least, int most) {
    return eventually([&] {
      const int count = brightOf(played.picture()).count;
      return count >= least && count <= most;
    });
  };
  played.press("Next");
  EXPECT_TRUE(becomes(frontal / 12, frontal / 5)) << "from the side";
  played.press("Next");
  EXPECT_TRUE(becomes(1, frontal / 14)) << "from afar";
  played.press("Next");
  EXPECT_TRUE(eventually([&] { return played.picture() == front; })) << "the first again";
  played.press("Prior");
  EXPECT_TRUE(becomes(1, frontal / 14)) << "the last";
}

TEST_F(Playing, EscapeAndTheCloseButtonEndIt) {
  PlayedScene escaped(folder_.write("plate.x3d", kPlate));
  escaped.press("Escape");
  EXPECT_EQ(escaped.exitStatus(), 0);
  PlayedScene closed(folder_.path() / "plate.x3d");
  closed.close();
  EXPECT_EQ(closed.exitStatus(), 0);
}

}  // namespace
}  // namespace pleura
