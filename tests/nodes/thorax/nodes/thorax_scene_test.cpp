#include <algorithm>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/standard/rendering/coordinate.h>
#include <pleura/nodes/standard/rendering/x3d_composed_geometry_node.h>
#include <pleura/nodes/thorax/deformable_shape2.h>
#include <pleura/tests/nodes/thorax/nodes/thorax_scene.h>
#include <pleura/tests/x3d/temporary_folder.h>
#include <pleura/x3d/browser/scene/state_hash.h>

namespace pleura {
namespace {

constexpr double kPeriod = 4;  // [s] at the scene's 15 breaths a minute

/// How far lung volume [m^3] and dome [m] swing in a breath.
struct Swings {
  double volume = 0, dome = 0;
};

Swings breathe(float depth) {
  const auto scene = breathingThorax();
  scene->set("BREATH.depth=" + std::to_string(depth));
  scene->set("BREATH.rate=15");
  double leastVolume = 1e9, mostVolume = -1e9, lowest = 1e9, highest = -1e9;
  constexpr int kTicks = 24;
  for (int k = 0; k <= kTicks; ++k) {
    scene->tick(k * kPeriod / kTicks);
    const double volume = valueOf<SFFloat>(*scene, "BREATH.lungVolume");
    const double dome = valueOf<SFFloat>(*scene, "BREATH.domeHeight");
    leastVolume = std::min(leastVolume, volume);
    mostVolume = std::max(mostVolume, volume);
    lowest = std::min(lowest, dome);
    highest = std::max(highest, dome);
  }
  return {mostVolume - leastVolume, highest - lowest};
}

double farthestFromRest(Scene& scene, const std::string& organ) {
  const auto rest = valueOf<MFVec3f>(scene, organ + ".origCoord");
  const auto now = valueOf<MFVec3f>(scene, organ + ".deformedCoord");
  EXPECT_EQ(rest.size(), now.size());
  float farthest = 0;
  for (std::size_t i = 0; i < std::min(rest.size(), now.size()); ++i)
    farthest = std::max(farthest, (now[i] - rest[i]).norm());
  return farthest;
}

TEST(ThoraxScene, LoadsWithoutFault) {
  const auto scene = breathingThorax();
  for (const auto& each : scene->diagnostics().all()) ADD_FAILURE() << toText(each);
}

/// What is shown of an organ: the points of its geometry's Coordinate.
const std::vector<Vec3f>& shown(DeformableShape2& organ) {
  auto& geometry = dynamic_cast<X3DComposedGeometryNode&>(*organ.geometry.getValue());
  return dynamic_cast<Coordinate&>(*geometry.coord.getValue()).point.getValue();
}

TEST(ThoraxScene, EveryOrganIsShownFromTheFirstTickAndMoves) {
  for (const bool breathes : {false, true}) {
    Scene scene;
    scene.load(sceneFolder() / "anatomy/thorax.x3d");
    scene.tick(0);
    int organs = 0;
    for (const auto& [name, node] : scene.document().names) {
      auto* organ = dynamic_cast<DeformableShape2*>(node.get());
      if (organ == nullptr) continue;
      ++organs;
      EXPECT_EQ(shown(*organ), organ->origCoord.getValue()) << name;
      if (breathes) {
        for (const auto& [rib, turning] : scene.document().names)
          if (Field* inflation = turning->getField("inflation")) inflation->setValueFromString("1");
        EXPECT_NE(shown(*organ), organ->origCoord.getValue()) << name;
        for (const auto& [rib, turning] : scene.document().names)
          if (Field* inflation = turning->getField("inflation")) inflation->setValueFromString("0");
      }
    }
    EXPECT_EQ(organs, 20 + 3) << "cartilages, lungs and diaphragm";
  }
}

TEST(ThoraxScene, QuietBreath) {
  const Swings quiet = breathe(1.f / 7);
  EXPECT_GE(quiet.volume, 0.4e-3) << "m^3; about half a litre (Boron 2017)";
  EXPECT_LE(quiet.volume, 0.6e-3);
  EXPECT_GE(quiet.dome, 0.8e-2) << "m";
  EXPECT_LE(quiet.dome, 2.1e-2);
}

TEST(ThoraxScene, BreathToTotalLungCapacity) {
  const Swings deep = breathe(1);
  EXPECT_GE(deep.volume, 2.5e-3) << "m^3";
  EXPECT_LE(deep.volume, 4e-3);
  EXPECT_GE(deep.dome, 5e-2) << "m";
  EXPECT_LE(deep.dome, 8.6e-2);
}

TEST(ThoraxScene, VolumeRisesWithInflationThroughoutInspiration) {
  const auto scene = breathingThorax();
  scene->set("BREATH.depth=1");
  double before = 0;
  for (int k = 0; k <= 12; ++k) {
    scene->tick(k * kPeriod / 3 / 12);
    const double volume = valueOf<SFFloat>(*scene, "BREATH.lungVolume");
    EXPECT_GE(volume, before) << "at " << k << "/12 of inspiration";
    before = volume;
  }
}

TEST(ThoraxScene, ExhaleReturnsToRest) {
  const auto scene = breathingThorax();
  scene->set("BREATH.depth=1");
  scene->tick(0);
  scene->tick(kPeriod / 3);
  for (const char* organ : {"LUNG_L", "LUNG_R", "DIAPHRAGM"})
    EXPECT_GT(farthestFromRest(*scene, organ), 1e-2) << organ << " at the top of the breath";
  scene->tick(kPeriod);
  for (const char* organ : {"LUNG_L", "LUNG_R", "DIAPHRAGM"})
    EXPECT_LE(farthestFromRest(*scene, organ), 1e-6) << organ;
}

TEST(ThoraxScene, TheShapeDoesNotDependOnTheWayThere) {
  const auto straight = breathingThorax();
  const auto roundabout = breathingThorax();
  for (auto* scene : {straight.get(), roundabout.get()}) scene->tick(0);
  for (const double t : {0.4, 1.1, 1.9, 3.0}) {
    roundabout->tick(t);
    valueOf<SFFloat>(*roundabout, "BREATH.lungVolume");
  }
  for (auto* scene : {straight.get(), roundabout.get()}) scene->tick(kPeriod + 1);
  EXPECT_EQ(valueOf<MFVec3f>(*straight, "LUNG_L.deformedCoord"),
            valueOf<MFVec3f>(*roundabout, "LUNG_L.deformedCoord"));
}

TEST(ThoraxScene, TwoRunsAreTheSameBitForBit) {
  const auto run = [] {
    const auto scene = breathingThorax();
    for (int k = 0; k < 5; ++k) scene->tick(k * 0.3);
    return stateHash(*scene);
  };
  EXPECT_EQ(run(), run());
}

/// A whole thorax in whose file stands `more`.
std::unique_ptr<Scene> thoraxWith(const std::string& more) {
  const TemporaryFolder folder;
  auto scene = std::make_unique<Scene>();
  ReaderLimits limits;
  limits.outsideFolder = true;
  scene->load(
      folder.write("s.x3d", "<Scene><ImportLibrary library='\"thorax\"'/><Inline DEF='BREATHING' url='\"" +
                                (sceneFolder() / "breathing_thorax.x3d").string() +
                                "\"'/>"
                                "<IMPORT inlineDEF='BREATHING' importedDEF='BREATH'/>"
                                "<IMPORT inlineDEF='BREATHING' importedDEF='LUNG_L'/>"
                                "<IMPORT inlineDEF='BREATHING' importedDEF='LUNG_L_CONTACTS'/>" +
                                more + "</Scene>"),
      limits);
  return scene;
}

TEST(ThoraxScene, AnOrganDeformsAsItsSceneSays) {
  const auto byDefault = thoraxWith("");
  const auto chosen = thoraxWith(
      "<OrganDeformation><LungContacts USE='LUNG_L_CONTACTS' containerField='contacts'/>"
      "<ChainmailDeformer smoothing='20'/></OrganDeformation>");
  for (auto* scene : {byDefault.get(), chosen.get()}) {
    for (const auto& each : scene->diagnostics().all()) ADD_FAILURE() << toText(each);
    scene->set("BREATH.depth=1");
    scene->tick(0);
    scene->tick(kPeriod / 3);
  }
  const auto filled = valueOf<MFVec3f>(*byDefault, "LUNG_L.deformedCoord");
  const auto deformed = valueOf<MFVec3f>(*chosen, "LUNG_L.deformedCoord");
  const auto held = valueOf<MFInt32>(*chosen, "LUNG_L_CONTACTS.index");
  ASSERT_EQ(filled.size(), deformed.size());
  EXPECT_LT(held.size(), filled.size());
  for (const int point : held)
    EXPECT_EQ(deformed[static_cast<std::size_t>(point)], filled[static_cast<std::size_t>(point)]);
  int differing = 0;
  for (std::size_t i = 0; i < filled.size(); ++i) differing += filled[i] != deformed[i] ? 1 : 0;
  EXPECT_GT(differing, static_cast<int>(filled.size() - held.size()) / 2);
}

TEST(ThoraxScene, ADeformerOfTwoOrgansIsTold) {
  const auto scene = thoraxWith(
      "<IMPORT inlineDEF='BREATHING' importedDEF='LUNG_R'/>"
      "<IMPORT inlineDEF='BREATHING' importedDEF='LUNG_R_CONTACTS'/>"
      "<OrganDeformation><LungContacts USE='LUNG_L_CONTACTS' containerField='contacts'/>"
      "<ChainmailDeformer DEF='CHAIN'/></OrganDeformation>"
      "<OrganDeformation><LungContacts USE='LUNG_R_CONTACTS' containerField='contacts'/>"
      "<ChainmailDeformer USE='CHAIN'/></OrganDeformation>");
  ASSERT_EQ(scene->diagnostics().all().size(), 1u);
  EXPECT_THAT(scene->diagnostics().all()[0].message,
              testing::HasSubstr("LUNG_R: deformer: CHAIN serves another shape"));
  scene->tick(0);
  for (const char* lung : {"LUNG_L", "LUNG_R"})
    EXPECT_EQ(valueOf<MFVec3f>(*scene, std::string(lung) + ".deformedCoord").size(),
              valueOf<MFVec3f>(*scene, std::string(lung) + ".origCoord").size());
  EXPECT_EQ(scene->diagnostics().all().size(), 1u);
}

TEST(ThoraxScene, AnOrganDeformationWithoutContactsIsTold) {
  const auto scene = thoraxWith("<OrganDeformation DEF='NONE'><ChainmailDeformer/></OrganDeformation>");
  ASSERT_EQ(scene->diagnostics().all().size(), 1u);
  EXPECT_THAT(scene->diagnostics().all()[0].message, testing::HasSubstr("NONE: contacts is missing"));
}

/// Figures as `pleura tradeoff` keeps them, for as long as it lives.
class MeasuredMachine {
 public:
  explicit MeasuredMachine(const std::string& rows) {
    const char* before = std::getenv("XDG_CACHE_HOME");
    before_ = before != nullptr ? before : "";
    folder_.write("pleura/tradeoff.csv", "# key\norgan,method,...\n" + rows);
    ::setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1);
  }
  ~MeasuredMachine() {
    before_.empty() ? ::unsetenv("XDG_CACHE_HOME") : ::setenv("XDG_CACHE_HOME", before_.c_str(), 1);
  }
  MeasuredMachine(const MeasuredMachine&) = delete;
  MeasuredMachine& operator=(const MeasuredMachine&) = delete;

 private:
  const TemporaryFolder folder_;
  std::string before_;
};

constexpr auto kFigures =
    "LUNG_L,reference,4096,9000,9000,0,1,1,0,0,0,0,0,0\n"
    "LUNG_L,smooth fill,0,0,0,0,0,1,3,0,0,0,0,0\n"
    "LUNG_L,ChainMail,0,0.5,0.6,1,1,1,2,0,0,0,0,0\n"
    "LUNG_L,linear FEM,64,0.2,0.3,1,1,1,1,0,0,0,0,0\n"
    "LUNG_L,corotational FEM,64,40,50,1,1,0,0.1,0,0,0,0,0\n"  // has not converged
    "LUNG_L,Neo-Hookean FEM,512,80,90,1,1,1,0.3,0,0,0,0,0\n";

struct Asked {
  const char *tolerance, *budget, *chosen;
  bool isTold;
};

TEST(ThoraxScene, TheCheapestThatHoldsToleranceAndBudgetIsChosen) {
  const MeasuredMachine machine(kFigures);
  for (const Asked& asked :
       {Asked{"0.0005", "0", "FiniteElementDeformer", false},
        Asked{"0.0015", "0.001", "FiniteElementDeformer", false},
        Asked{"0.0025", "0.001", "FiniteElementDeformer", false}, Asked{"0.01", "0", "", false},
        Asked{"0.0001", "0", "FiniteElementDeformer", true},
        Asked{"0.0005", "0.001", "FiniteElementDeformer", true}}) {
    const auto scene =
        thoraxWith(std::string("<OrganDeformation DEF='CHOICE' tolerance='") + asked.tolerance +
                   "' budget='" + asked.budget +
                   "'><LungContacts USE='LUNG_L_CONTACTS' containerField='contacts'/></OrganDeformation>");
    EXPECT_EQ(valueOf<SFString>(*scene, "CHOICE.chosen"), asked.chosen) << asked.tolerance;
    EXPECT_EQ(scene->diagnostics().warnings(), asked.isTold ? 1u : 0u) << asked.tolerance;
    for (const auto& each : scene->diagnostics().all())
      EXPECT_THAT(each.message, testing::HasSubstr("CHOICE: no way to deform LUNG_L is known to hold"));
  }
}

TEST(ThoraxScene, WhereNothingWasMeasuredThatIsTold) {
  const MeasuredMachine machine("");
  const auto scene = thoraxWith(
      "<OrganDeformation DEF='CHOICE' tolerance='0.001'><LungContacts USE='LUNG_L_CONTACTS' "
      "containerField='contacts'/></OrganDeformation>");
  ASSERT_EQ(scene->diagnostics().all().size(), 1u);
  EXPECT_THAT(scene->diagnostics().all()[0].message, testing::HasSubstr("CHOICE: LUNG_L was not measured"));
}

/// Each deformer is asked for the same breath, and for what it can't do.
class Deformer : public ::testing::TestWithParam<const char*> {};

TEST_P(Deformer, KeepsWhatIsHeldAndReturnsToRest) {
  const auto scene = thoraxWith(
      std::string("<OrganDeformation><LungContacts USE='LUNG_L_CONTACTS' containerField='contacts'/>") +
      GetParam() + "</OrganDeformation>");
  scene->set("BREATH.depth=0.3");
  scene->tick(0);
  const auto rest = valueOf<MFVec3f>(*scene, "LUNG_L.deformedCoord");
  scene->tick(kPeriod / 3);
  const auto held = valueOf<MFInt32>(*scene, "LUNG_L_CONTACTS.index");
  const auto targets = valueOf<MFVec3f>(*scene, "LUNG_L_CONTACTS.point");
  const auto deformed = valueOf<MFVec3f>(*scene, "LUNG_L.deformedCoord");
  for (std::size_t i = 0; i < held.size(); ++i)
    EXPECT_EQ(deformed[static_cast<std::size_t>(held[i])], targets[i]);
  EXPECT_GT(farthestFromRest(*scene, "LUNG_L"), 5e-3);
  EXPECT_LT(farthestFromRest(*scene, "LUNG_L"), 6e-2);
  scene->tick(kPeriod);
  EXPECT_LE(farthestFromRest(*scene, "LUNG_L"), 1e-5);
  for (const auto& each : scene->diagnostics().all()) ADD_FAILURE() << toText(each);
}

TEST_P(Deformer, ASceneWithOneGoesOnWhereTheShapeIsNone) {
  // One triangle, flat, with a hole of a quarter, inside out, a point that is none.
  for (const char* geometry :
       {"<IndexedTriangleSet index='0 1 2'><Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedTriangleSet>",
        "<IndexedTriangleSet index='0 1 2 0 2 3 0 3 1'><Coordinate point='0 0 0 1 0 0 0 1 0 0 0 "
        "1'/></IndexedTriangleSet>",
        "<IndexedTriangleSet index='0 1 2 0 2 3 0 3 1 1 3 2'><Coordinate point='0 0 0 1 0 0 0 1 0 0 0 "
        "1'/></IndexedTriangleSet>",
        "<IndexedTriangleSet index='0 1 9'><Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedTriangleSet>"}) {
    std::string deformer = GetParam();
    deformer.insert(deformer.find('/'), " containerField='deformer'");
    const auto scene = sceneOf(
        "<ImportLibrary library='\"thorax\"'/><DeformableShape2 DEF='ORGAN' contactIndex='0' "
        "contactPoint='0.1 0 0'>" +
        deformer + geometry + "</DeformableShape2>");
    scene->tick(0);
    for (const Vec3f& point : valueOf<MFVec3f>(*scene, "ORGAN.deformedCoord"))
      EXPECT_TRUE(point.allFinite()) << geometry;
    for (const auto& each : scene->diagnostics().all())
      EXPECT_THAT(each.message,
                  testing::AnyOf(testing::StartsWith("ORGAN: "), testing::HasSubstr("Deformer: ")));
  }
}

INSTANTIATE_TEST_SUITE_P(OfAKind, Deformer,
                         ::testing::Values("<ChainmailDeformer/>", "<SpringDeformer/>",
                                           "<SpringDeformer interior='VOLUME'/>",
                                           "<FiniteElementDeformer model='LINEAR' elements='200'/>",
                                           "<FiniteElementDeformer model='COROTATIONAL' elements='60'/>",
                                           "<FiniteElementDeformer model='NEO_HOOKEAN' elements='60'/>"));

TEST(FiniteElementDeformer, TellsWhatItCantBe) {
  for (const char* bad :
       {"model='CUBIC'", "poissonRatio='0.5'", "density='-1'", "youngsModulus='0'", "elements='0'"}) {
    const auto scene = thoraxWith(
        std::string("<OrganDeformation><LungContacts USE='LUNG_L_CONTACTS' containerField='contacts'/>"
                    "<FiniteElementDeformer DEF='TISSUE' ") +
        bad + "/></OrganDeformation>");
    scene->tick(0);
    EXPECT_EQ(valueOf<MFVec3f>(*scene, "LUNG_L.deformedCoord").size(),
              valueOf<MFVec3f>(*scene, "LUNG_L.origCoord").size());
    EXPECT_FALSE(scene->diagnostics().all().empty()) << bad;
  }
}

TEST(FiniteElementDeformer, WithInertiaItGoesOnWhereTheDriveStops) {
  const auto scene = thoraxWith(
      "<OrganDeformation><LungContacts USE='LUNG_L_CONTACTS' containerField='contacts'/>"
      "<FiniteElementDeformer model='LINEAR' elements='100' quasiStatic='false'/></OrganDeformation>");
  scene->set("BREATH.depth=1");
  const auto shape = [&] { return valueOf<MFVec3f>(*scene, "LUNG_L.deformedCoord"); };
  double now = 0;
  scene->tick(0);
  shape();
  for (; now < 1; shape()) scene->tick(now += 0.02);
  scene->set("BREATH.paused=true");
  scene->tick(now += 0.02);
  const auto early = shape();
  for (int k = 0; k < 100; ++k) {
    scene->tick(now += 0.02);
    shape();
  }
  const auto late = shape();
  EXPECT_NE(early, late) << "damped motion goes on";
  scene->tick(now += 0.02);
  float moved = 0;
  const auto last = shape();
  for (std::size_t i = 0; i < last.size(); ++i) moved = std::max(moved, (last[i] - late[i]).norm());
  EXPECT_LT(moved, 1e-4f) << "and comes to rest";
}

TEST(ThoraxScene, RibsTurnWithTheBreath) {
  const auto scene = breathingThorax();
  scene->set("BREATH.depth=1");
  scene->tick(0);
  EXPECT_NEAR(valueOf<SFRotation>(*scene, "RIB_L5.rotation").angle, 0, 1e-6);
  scene->tick(kPeriod / 3);
  EXPECT_GT(valueOf<SFRotation>(*scene, "RIB_L5.rotation").angle, 0.1);
}

}  // namespace
}  // namespace pleura
