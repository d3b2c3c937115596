#include <gtest/gtest.h>

#include <pleura/nodes/built_in_nodes.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

class EveryType : public ::testing::Test {
 protected:
  EveryType() { registerBuiltInNodes(registry); }
  NodeRegistry registry;
};

TEST_F(EveryType, IsMadeByNameAndKnowsItsType) {
  ASSERT_GE(registry.types().size(), 70u);
  for (const NodeType* type : registry.types()) {
    const NodeType* found = registry.find(type->name());
    ASSERT_EQ(found, type);
    EXPECT_EQ(&found->create()->type(), type);
    EXPECT_FALSE(type->meaning().empty()) << type->name();
  }
}

TEST_F(EveryType, PrintsAndReadsBackEachDefault) {
  for (const NodeType* type : registry.types()) {
    const NodePtr node = type->create();
    for (const auto& declared : type->fields()) {
      Field& field = declared->of(*node);
      EXPECT_EQ(field.getFullName(), type->name() + "." + declared->name);
      EXPECT_FALSE(declared->meaning.empty()) << field.getFullName();
      const std::string text = field.getValueAsString();
      field.setValueFromString(text, node->id);
      EXPECT_EQ(field.getValueAsString(), text) << field.getFullName();
    }
  }
}

TEST_F(EveryType, TakesSetAndChangedForInputOutputOnly) {
  for (const NodeType* type : registry.types())
    for (const auto& declared : type->fields()) {
      const bool isBoth = declared->access == Access::inputOutput;
      const NodeField* set = type->find("set_" + declared->name);
      const NodeField* changed = type->find(declared->name + "_changed");
      EXPECT_EQ(changed == declared.get(), isBoth) << type->name() << "." << declared->name;
      EXPECT_EQ(set == declared.get(), isBoth) << type->name() << "." << declared->name;
    }
}

TEST_F(EveryType, ClosesInitializeOnlyFieldsOnce) {
  TestContext context;
  for (const NodeType* type : registry.types()) {
    const NodePtr node = type->create();
    node->initialize(context);
    node->initialize(context);
    for (const auto& declared : type->fields()) {
      Field& field = declared->of(*node);
      const std::string text = field.getValueAsString();
      if (declared->access == Access::initializeOnly || declared->access == Access::outputOnly) {
        EXPECT_THROW(field.setValueFromString(text), FieldAccessError) << field.getFullName();
      } else {
        EXPECT_NO_THROW(field.setValueFromString(text)) << field.getFullName();
      }
    }
  }
  EXPECT_TRUE(context.warnings.empty());
}

}  // namespace
}  // namespace pleura
