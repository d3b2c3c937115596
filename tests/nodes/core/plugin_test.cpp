#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/core/plugin.h>

namespace pleura {
namespace {

using ::testing::HasSubstr;

class Plugins : public ::testing::Test {
 protected:
  std::string refusal(std::string_view library) {
    try {
      loader.load(library, registry);
    } catch (const PluginError& error) {
      return error.what();
    }
    return {};
  }

  NodeRegistry registry;
  PluginLoader loader{{PLEURA_TEST_PLUGINS}};
};

TEST_F(Plugins, RegisterTheirNodes) {
  loader.load("test_good", registry);
  const NodeType* type = registry.find("Larynx");
  ASSERT_NE(type, nullptr);
  const NodePtr node = type->create();
  EXPECT_EQ(node->getField("pitch")->getValueAsString(), "110");
}

TEST_F(Plugins, AreLoadedOnceAndUnderEveryNameOfTheirs) {
  for (const auto* name :
       {"test_good", "\"test_good\"", "test_good.dll", "libtest_good.so", "libpleura_test_good.so"})
    EXPECT_NO_THROW(loader.load(name, registry)) << name;
  EXPECT_EQ(registry.types().size(), 1u);
}

TEST_F(Plugins, OfAnotherAbiAreRefused) {
  EXPECT_THAT(refusal("test_other_abi"), HasSubstr("ABI " + std::to_string(kPluginAbi + 1)));
  EXPECT_TRUE(registry.types().empty());
}

TEST_F(Plugins, WithoutTheSymbolsAreRefused) {
  EXPECT_THAT(refusal("test_no_plugin"), HasSubstr("pleura_plugin_abi"));
}

TEST_F(Plugins, WithATypeThatIsThereLeaveTheRegistryAsItWas) {
  loader.load("test_good", registry);
  EXPECT_THAT(refusal("test_duplicate"), HasSubstr("Larynx"));
  EXPECT_EQ(registry.find("Trachea"), nullptr);
  EXPECT_EQ(registry.types().size(), 1u);
}

TEST_F(Plugins, ThatAreMissingAreNamedWithTheFoldersTried) {
  const std::string message = refusal("spleen");
  EXPECT_THAT(message, HasSubstr("libpleura_spleen.so"));
  EXPECT_THAT(message, HasSubstr(PLEURA_TEST_PLUGINS));
}

TEST_F(Plugins, AreNamedNotPathed) {
  for (const auto* path :
       {"../test_good", "/tmp/test_good", "a/b", "", "  ", "te st", "x;y", "$HOME", "test.good"})
    EXPECT_THAT(refusal(path), HasSubstr("is no name of a library")) << path;
}

TEST_F(Plugins, ThatAreNoLibraryAtAllAreRefused) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "pleura_plugins";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "libpleura_broken.so") << "no library";
  PluginLoader own({folder});
  EXPECT_THROW(own.load("broken", registry), PluginError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace pleura
