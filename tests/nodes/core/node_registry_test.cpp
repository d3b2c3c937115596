#include <gtest/gtest.h>

#include <pleura/nodes/core/node_registry.h>

namespace pleura {
namespace {

class Rib : public Node {
 public:
  static void declare(NodeType& type) {
    Node::declare(type);
    type.named("Rib", "Pleura");
  }
};

class Sternum : public Node {
 public:
  static void declare(NodeType& type) {
    Node::declare(type);
    type.named("Sternum", "Pleura");
  }
};

class NodeRegistryTest : public ::testing::Test {
 protected:
  NodeRegistryTest() {
    registry.add<Sternum>();
    registry.add<Rib>();
  }
  NodeRegistry registry;
};

TEST_F(NodeRegistryTest, MakesNodesByName) {
  ASSERT_NE(registry.find("Rib"), nullptr);
  EXPECT_NE(dynamic_cast<Rib*>(registry.find("Rib")->create().get()), nullptr);
  EXPECT_EQ(registry.find("rib"), nullptr);
  EXPECT_EQ(registry.find(""), nullptr);
}

TEST_F(NodeRegistryTest, RefusesDuplicatesAndKeepsTheFirst) {
  EXPECT_THROW(registry.add<Rib>(), DuplicateTypeError);
  EXPECT_THROW(registry.addAlias("Sternum", "Rib"), DuplicateTypeError);
  EXPECT_EQ(registry.find("Sternum"), &nodeType<Sternum>());
}

TEST_F(NodeRegistryTest, KnowsAliases) {
  registry.addAlias("Costa", "Rib");
  EXPECT_EQ(registry.find("Costa"), &nodeType<Rib>());
  EXPECT_THROW(registry.addAlias("Vertebra", "Spine"), std::out_of_range);
  EXPECT_EQ(registry.find("Vertebra"), nullptr);
}

TEST_F(NodeRegistryTest, ListsTypesInOrderWithoutAliases) {
  registry.addAlias("Costa", "Rib");
  EXPECT_EQ(registry.types(), (std::vector<const NodeType*>{&nodeType<Rib>(), &nodeType<Sternum>()}));
}

TEST_F(NodeRegistryTest, NamesTheNearest) {
  EXPECT_EQ(registry.nearest("sternun"), "Sternum");
  EXPECT_EQ(registry.nearest("Ribs"), "Rib");
  EXPECT_EQ(registry.nearest("Diaphragm"), "");
  EXPECT_EQ(registry.nearest(""), "");
  EXPECT_EQ(registry.nearest(std::string(100000, 'R')), "");
}

}  // namespace
}  // namespace pleura
