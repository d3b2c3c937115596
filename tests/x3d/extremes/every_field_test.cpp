#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/errors.h>
#include <pleura/nodes/built_in_nodes.h>
#include <pleura/tests/x3d/browser/load_scene.h>
#include <pleura/x3d/browser/render/renderer.h>
#include <pleura/x3d/browser/scene/state_hash.h>
#include <pleura/x3d/browser/touch/touch_session.h>
#include <pleura/x3d/browser/view/scene_view.h>

namespace pleura {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// What stands around a node of this containerField so that it is used, and what stands inside it.
struct Surroundings {
  const char *before, *inside, *after;
};

Surroundings around(const std::string& containerField) {
  constexpr auto kPoints = "<Coordinate point='0 0 0 1 0 0 0 1 0'/>";
  constexpr auto kTriangle =
      "<Shape><IndexedTriangleSet index='0 1 2'><Coordinate point='0 0 0 1 0 0 0 1 0'/>";
  constexpr auto kTouchable = "<Shape><Appearance><SmoothSurface/></Appearance><Box/></Shape><DeviceInfo>";
  static const std::map<std::string, Surroundings> all = {
      {"appearance", {"<Shape>", "", "<Box/></Shape>"}},
      {"material", {"<Shape><Appearance>", "", "</Appearance><Box/></Shape>"}},
      {"lineProperties", {"<Shape><Appearance>", "", "</Appearance><Box/></Shape>"}},
      {"pointProperties", {"<Shape><Appearance>", "", "</Appearance><Box/></Shape>"}},
      {"geometry", {"<Shape>", kPoints, "</Shape>"}},
      {"coord", {"<Shape><IndexedTriangleSet index='0 1 2'>", "", "</IndexedTriangleSet></Shape>"}},
      {"color", {kTriangle, "", "</IndexedTriangleSet></Shape>"}},
      {"normal", {kTriangle, "", "</IndexedTriangleSet></Shape>"}},
      {"texCoord", {kTriangle, "", "</IndexedTriangleSet></Shape>"}},
      {"fontStyle", {"<Shape><Text string='\"a\"'>", "", "</Text></Shape>"}},
      {"surface", {"<Shape><Appearance>", "", "</Appearance><Box/></Shape>"}},
      {"device", {kTouchable, "", "</DeviceInfo>"}},
      {"xFunction", {"<TimeFunctionEffect>", "", "</TimeFunctionEffect>"}},
      {"deformer", {"<DeformableShape2>", "", "<IndexedTriangleSet/></DeformableShape2>"}},
      {"value", {"<Group><MetadataSet containerField='metadata'>", "", "</MetadataSet></Group>"}},
      {"children", {"", "<Shape><Box/></Shape>", ""}}};
  return all.at(containerField);
}

/// How many numbers a value of this type has; 0 where it has none.
int numbersIn(FieldType type) {
  using enum FieldType;
  static const std::map<FieldType, int> all = {
      {SFFloat, 1}, {SFDouble, 1},   {SFTime, 1},     {SFInt32, 1},    {SFVec2f, 2},     {SFVec2d, 2},
      {SFVec3f, 3}, {SFVec3d, 3},    {SFColor, 3},    {SFVec4f, 4},    {SFVec4d, 4},     {SFColorRGBA, 4},
      {SFImage, 4}, {SFRotation, 4}, {SFMatrix3f, 9}, {SFMatrix3d, 9}, {SFMatrix4f, 16}, {SFMatrix4d, 16}};
  const auto found = all.find(singleOf(type));
  return found != all.end() ? found->second : 0;
}

/// A value of that type which is nothing but this number.
std::string valueOf(FieldType type, const std::string& number) {
  std::string text;
  for (int i = 0; i < numbersIn(type); ++i) text += (i > 0 ? " " : "") + number;
  return text;
}

bool isState(const NodeField& field) {
  return field.access == Access::inputOutput || field.access == Access::initializeOnly;
}

/// For each field with numbers that a file can give a value, a node which has that number there; its name is
/// the field's.
std::string nodesWith(const NodeType& type, const std::string& number) {
  const Surroundings& s = around(type.containerField());
  std::string elements = "<ImportLibrary library='thorax'/>";
  for (const auto& field : type.fields())
    if (isState(*field) && numbersIn(field->type) > 0)
      elements += std::string(s.before) + "<" + type.name() + " DEF='" + field->name + "' " + field->name +
                  "='" + valueOf(field->type, number) + "'>" + s.inside + "</" + type.name() + ">" + s.after;
  return elements;
}

std::vector<std::string> said(const Scene& scene) {
  std::vector<std::string> lines;
  for (const auto& each : scene.diagnostics().all()) lines.push_back(toText(each));
  return lines;
}

class EveryField : public testing::Test {
 protected:
  EveryField() {
    registerBuiltInNodes(registry_);
    PluginLoader().load("thorax", registry_);
  }

  /// The scene is run, touched by a stylus where it has one or a surface, hashed and drawn.
  void use(Scene& scene) {
    TouchSession touch(scene, {.device = "simulated"}, TouchSession::Clock::virtualTime);
    try {
      touch.open();
    } catch (const haptics::DeviceError&) {  // figures that make no stylus
    }
    SceneView view(scene);
    render::Renderer renderer(*context_);
    for (const double now : {0.0, 0.1, 1e6}) {
      scene.tick(now);
      if (now < 1) touch.advance(now);
      stateHash(scene);
      renderer.draw(view.update(), 32, 32);
    }
  }

  NodeRegistry registry_;
  std::unique_ptr<render::GlContext> context_ = render::makeOffscreenContext();
};

TEST_F(EveryField, RefusesWhatIsNoFiniteNumberByItsName) {
  for (const char* number : {"nan", "NaN", "-nan", "inf", "-inf", "Infinity", "1e999"})
    for (const NodeType* type : registry_.types()) {
      const auto scene = sceneOf(nodesWith(*type, number));
      const auto lines = said(*scene);
      for (const auto& field : type->fields()) {
        if (!isState(*field) || numbersIn(field->type) == 0) continue;
        EXPECT_THAT(lines, Contains(HasSubstr(": error: " + field->name + "." + field->name + ": expected ")))
            << type->name() << " " << number;
      }
      use(*scene);
    }
}

TEST_F(EveryField, LivesWithTheLargestAndTheSmallestInAFile) {
  for (const char* number : {"3e38", "-3e38", "1e-45", "2147483647", "-2147483648", "-1", "0"})
    for (const NodeType* type : registry_.types()) {
      SCOPED_TRACE(type->name() + " " + number);
      use(*sceneOf(nodesWith(*type, number)));
    }
}

TEST_F(EveryField, LivesWithThemWhileItRuns) {
  for (const char* number : {"3e38", "-3e38", "1e-45", "2147483647", "-2147483648", "-1", "0", "nan", "inf"})
    for (const NodeType* type : registry_.types()) {
      SCOPED_TRACE(type->name() + " " + number);
      const Surroundings& s = around(type->containerField());
      const auto scene = sceneOf("<ImportLibrary library='thorax'/>" + std::string(s.before) + "<" +
                                 type->name() + " DEF='N'>" + s.inside + "</" + type->name() + ">" + s.after);
      use(*scene);
      for (const auto& field : type->fields()) {
        if (!canSet(field->access) || numbersIn(field->type) == 0) continue;
        try {
          scene->set("N." + field->name + "=" + valueOf(field->type, number));
        } catch (const FieldError&) {
          continue;  // out of the field's range
        }
      }
      use(*scene);
    }
}

}  // namespace
}  // namespace pleura
