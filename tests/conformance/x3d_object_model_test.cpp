#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include <gtest/gtest.h>
#include <libxml/parser.h>
#include <libxml/tree.h>

#include <pleura/nodes/standard/register.h>

namespace pleura {
namespace {

struct ModelField {
  std::string type, access;
  std::optional<std::string> byDefault, least, most;
};

struct ModelNode {
  std::string component, level, containerField;
  std::map<std::string, ModelField> fields;
};

using Model = std::map<std::string, ModelNode>;

std::optional<std::string> attribute(xmlNode* element, const char* name) {
  const std::unique_ptr<xmlChar, decltype(xmlFree)> text(
      xmlGetProp(element, reinterpret_cast<const xmlChar*>(name)), xmlFree);
  if (text == nullptr) return std::nullopt;
  return reinterpret_cast<const char*>(text.get());
}

std::string nameOf(xmlNode* element) { return reinterpret_cast<const char*>(element->name); }

ModelNode readInterface(xmlNode* definition) {
  ModelNode node;
  for (xmlNode* child = definition->children; child != nullptr; child = child->next) {
    const std::string tag = child->type == XML_ELEMENT_NODE ? nameOf(child) : "";
    if (tag == "componentInfo") {
      node.component = attribute(child, "name").value_or("");
      node.level = attribute(child, "level").value_or("");
    } else if (tag == "containerField") {
      node.containerField = attribute(child, "default").value_or("");
    } else if (tag == "field") {
      node.fields[*attribute(child, "name")] = {*attribute(child, "type"), *attribute(child, "accessType"),
                                                attribute(child, "default"), attribute(child, "minInclusive"),
                                                attribute(child, "maxInclusive")};
    }
  }
  return node;
}

void readConcreteNodes(xmlNode* element, Model& model) {
  for (; element != nullptr; element = element->next) {
    if (element->type == XML_ELEMENT_NODE && nameOf(element) == "ConcreteNode") {
      for (xmlNode* child = element->children; child != nullptr; child = child->next)
        if (child->type == XML_ELEMENT_NODE && nameOf(child) == "InterfaceDefinition")
          model[*attribute(element, "name")] = readInterface(child);
    }
    readConcreteNodes(element->children, model);
  }
}

std::filesystem::path modelFile() {
  const char* shared = std::getenv("PLEURA_SHARED");
  const std::filesystem::path folder = shared != nullptr
                                           ? std::filesystem::path(shared)
                                           : std::filesystem::path(PLEURA_SOURCE_DIR) / "../shared";
  return folder / "x3d/X3dUnifiedObjectModel-4.0.xml";
}

/// Attributes of X3D's XML encoding and prototypes: the reader deals with them, nodes have no such fields.
bool belongsToTheEncoding(const std::string& field) {
  static const std::set<std::string> names = {"IS", "DEF", "USE", "class", "id", "style"};
  return names.contains(field);
}

/// FontStyle.style is a field of X3D and takes the place of the encoding's attribute of that name.
bool isFieldAfterAll(const std::string& type, const std::string& field) {
  return type == "FontStyle" && field == "style";
}

std::string emptyText(FieldType type) {
  if (isMulti(type)) return "";
  static const std::map<FieldType, std::string> texts = {
      {FieldType::SFBool, "false"},      {FieldType::SFString, ""},     {FieldType::SFNode, "NULL"},
      {FieldType::SFVec2f, "0 0"},       {FieldType::SFVec3f, "0 0 0"}, {FieldType::SFColor, "0 0 0"},
      {FieldType::SFRotation, "0 0 1 0"}};
  const auto found = texts.find(type);
  return found != texts.end() ? found->second : "0";
}

class X3dObjectModel : public ::testing::Test {
 protected:
  void SetUp() override {
    registerStandardNodes(registry);
    const auto file = modelFile();
    if (!std::filesystem::exists(file))
      GTEST_SKIP() << "X3D's object model is not there: " << file
                   << "; PLEURA_SHARED names the folder that has x3d/X3dUnifiedObjectModel-4.0.xml";
    const std::unique_ptr<xmlDoc, decltype(&xmlFreeDoc)> document(
        xmlReadFile(file.c_str(), nullptr, XML_PARSE_NONET), &xmlFreeDoc);
    ASSERT_NE(document, nullptr);
    readConcreteNodes(xmlDocGetRootElement(document.get()), model);
    ASSERT_GT(model.size(), 200u);
  }

  NodeRegistry registry;
  Model model;
};

TEST_F(X3dObjectModel, HasEveryRegisteredTypeAtTheSamePlace) {
  for (const NodeType* type : registry.types()) {
    SCOPED_TRACE(type->name());
    ASSERT_TRUE(model.contains(type->name()));
    const ModelNode& expected = model[type->name()];
    EXPECT_EQ(type->component(), expected.component);
    EXPECT_EQ(std::to_string(type->level()), expected.level);
    EXPECT_EQ(type->containerField(), expected.containerField);
  }
}

TEST_F(X3dObjectModel, HasEveryDeclaredFieldAndNoOther) {
  for (const NodeType* type : registry.types()) {
    std::set<std::string> expected;
    for (const auto& [name, field] : model[type->name()].fields)
      if (!belongsToTheEncoding(name) || isFieldAfterAll(type->name(), name)) expected.insert(name);
    std::set<std::string> declared;
    for (const auto& field : type->fields())
      if (!field->isExtension) declared.insert(field->name);
    EXPECT_EQ(declared, expected) << type->name();
  }
}

TEST_F(X3dObjectModel, IsExtendedByTouchAlone) {
  std::set<std::string> extensions;
  for (const NodeType* type : registry.types())
    for (const auto& field : type->fields())
      if (field->isExtension) {
        extensions.insert(field->name);
        EXPECT_FALSE(model[type->name()].fields.contains(field->name)) << type->name() << "." << field->name;
      }
  EXPECT_EQ(extensions, (std::set<std::string>{"isTouched", "force", "contactPoint", "contactNormal",
                                               "contactDepth", "surface"}));
}

TEST_F(X3dObjectModel, AgreesOnTypeAndAccess) {
  for (const NodeType* type : registry.types())
    for (const auto& field : type->fields()) {
      if (field->isExtension) continue;
      const ModelField& expected = model[type->name()].fields[field->name];
      EXPECT_EQ(name(field->type), expected.type) << type->name() << "." << field->name;
      EXPECT_EQ(name(field->access), expected.access) << type->name() << "." << field->name;
    }
}

TEST_F(X3dObjectModel, AgreesOnDefaults) {
  for (const NodeType* type : registry.types())
    for (const auto& field : type->fields()) {
      if (field->isExtension) continue;
      const NodePtr node = type->create();
      Field& actual = field->of(*node);
      const std::string text = actual.getValueAsString();
      const ModelField& expected = model[type->name()].fields[field->name];
      actual.setValueFromString(expected.byDefault.value_or(emptyText(field->type)), node->id);
      EXPECT_EQ(text, actual.getValueAsString()) << type->name() << "." << field->name;
      EXPECT_EQ(text, field->defaultText) << type->name() << "." << field->name;
    }
}

TEST_F(X3dObjectModel, AgreesOnRanges) {
  for (const NodeType* type : registry.types())
    for (const auto& field : type->fields()) {
      if (field->isExtension) continue;
      const ModelField& expected = model[type->name()].fields[field->name];
      if (field->access == Access::outputOnly) continue;
      if (expected.least) {
        EXPECT_EQ(field->minimum, std::stod(*expected.least)) << type->name() << "." << field->name;
      }
      if (expected.most) {
        EXPECT_NEAR(field->maximum, std::stod(*expected.most), 1e-5) << type->name() << "." << field->name;
      }
    }
}

}  // namespace
}  // namespace pleura
