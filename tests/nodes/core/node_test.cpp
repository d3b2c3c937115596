#include <gtest/gtest.h>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

/// Fields that stand beside Node, as those of X3DBoundedObject.
class Labelled {
 public:
  SFString label;
  static void declare(NodeType& type) {
    type.field<&Labelled::label>("label", Access::inputOutput, "none").means("what it is called");
  }

 protected:
  ~Labelled() = default;
};

class Lung : public Node, public Labelled {
 public:
  SFFloat volume;
  SFInt32 lobes;
  SFFloat pressure;
  TypedSFNode<Lung> other;
  int initializations = 0;

  static void declare(NodeType& type) {
    Node::declare(type);
    Labelled::declare(type);
    type.named("Lung", "Pleura", 2).containedIn("organ").means("half of what breathes");
    using enum Access;
    type.field<&Lung::volume>("volume", inputOutput, 2.5f).measuredIn(Unit::volume).within(0, 8);
    type.field<&Lung::lobes>("lobes", initializeOnly, 3);
    type.field<&Lung::pressure>("pressure", outputOnly, 0).positive();
    type.field<&Lung::other>("other", inputOutput, {});
  }

 protected:
  void onInitialize() override { ++initializations; }
};

class LeftLung : public Lung {
 public:
  static void declare(NodeType& type) {
    Lung::declare(type);
    type.named("LeftLung", "Pleura");
    type.field<&Lung::lobes>("lobes", Access::initializeOnly, 2);
  }
};

TEST(Node, HasItsFieldsAtTheirDefaults) {
  const auto lung = create<Lung>();
  EXPECT_EQ(lung->volume.getValue(), 2.5f);
  EXPECT_EQ(lung->lobes.getValue(), 3);
  EXPECT_EQ(lung->label.getValue(), "none");
  EXPECT_EQ(lung->metadata.getValue(), nullptr);
  EXPECT_EQ(create<LeftLung>()->lobes.getValue(), 2) << "a class may give another default";
}

TEST(Node, FindsFieldsByNameAndAlias) {
  const auto lung = create<Lung>();
  EXPECT_EQ(lung->getField("volume"), &lung->volume);
  EXPECT_EQ(lung->getField("set_volume"), &lung->volume);
  EXPECT_EQ(lung->getField("volume_changed"), &lung->volume);
  EXPECT_EQ(lung->getField("label"), &lung->label);
  EXPECT_EQ(lung->getField("set_lobes"), nullptr) << "only inputOutput fields have other names";
  for (const auto* none : {"", "set_", "_changed", "Volume", "set_volume_changed"})
    EXPECT_EQ(lung->getField(none), nullptr) << none;
}

TEST(Node, DescribesItselfByNameThenType) {
  const auto lung = create<Lung>();
  EXPECT_EQ(lung->volume.getFullName(), "Lung.volume");
  lung->setName("LUNG_L");
  EXPECT_EQ(lung->describe(), "LUNG_L");
  EXPECT_EQ(lung->volume.getFullName(), "LUNG_L.volume");
}

TEST(Node, ClosesInitializeOnlyFieldsWhenInitialized) {
  TestContext context;
  const auto lung = create<Lung>();
  lung->lobes.setValue(4);
  EXPECT_FALSE(lung->isInitialized());
  lung->initialize(context);
  lung->initialize(context);
  EXPECT_EQ(lung->initializations, 1);
  EXPECT_THROW(lung->lobes.setValue(5), FieldAccessError);
  lung->lobes.setValue(5, lung->id);
  EXPECT_EQ(lung->lobes.getValue(), 5) << "the node itself is exempt";
}

TEST(Node, KeepsRangesAtReading) {
  const auto lung = create<Lung>();
  EXPECT_THROW(lung->volume.setValueFromString("9"), FieldParseError);
  EXPECT_THROW(lung->pressure.setValueFromString("0", lung->id), FieldParseError) << "positive excludes 0";
  EXPECT_EQ(lung->volume.getValue(), 2.5f);
}

TEST(Node, AdmitsOnlyNodesOfTheRightClass) {
  const auto lung = create<Lung>();
  EXPECT_TRUE(lung->other.admits(*create<LeftLung>()));
  EXPECT_FALSE(lung->other.admits(Node()));
  lung->other.setValue(create<LeftLung>());
  EXPECT_NE(lung->other.get(), nullptr);
}

TEST(NodeType, KnowsWhatWasDeclared) {
  const NodeType& type = nodeType<Lung>();
  EXPECT_EQ(&type, &nodeType<Lung>()) << "declared once";
  EXPECT_EQ(&type, &create<Lung>()->type());
  EXPECT_EQ(type.component(), "Pleura");
  EXPECT_EQ(type.level(), 2);
  EXPECT_EQ(type.containerField(), "organ");
  EXPECT_EQ(type.find("volume")->unit, Unit::volume);
  EXPECT_EQ(type.find("volume")->maximum, 8);
  EXPECT_EQ(type.find("volume")->defaultText, "2.5");
  EXPECT_EQ(nodeType<LeftLung>().fields().size(), type.fields().size()) << "declared again, not twice";
}

}  // namespace
}  // namespace pleura
