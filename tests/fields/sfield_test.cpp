#include <type_traits>

#include <gtest/gtest.h>

#include <pleura/fields/field_types.h>

namespace pleura {
namespace {

template <class F>
class SFieldTest : public testing::Test {};

using SingleFields = testing::Types<SFBool, SFColor, SFColorRGBA, SFDouble, SFFloat, SFImage, SFInt32,
                                    SFMatrix3d, SFMatrix3f, SFMatrix4d, SFMatrix4f, SFNode, SFRotation,
                                    SFString, SFTime, SFVec2d, SFVec2f, SFVec3d, SFVec3f, SFVec4d, SFVec4f>;
TYPED_TEST_SUITE(SFieldTest, SingleFields);

template <class T>
T another() {
  if constexpr (std::is_arithmetic_v<T>) {
    return T{1};
  } else if constexpr (requires { T::Ones(); }) {
    return T::Ones();
  } else if constexpr (std::is_same_v<T, Rotation>) {
    return Rotation(1, 0, 0, 2);
  } else if constexpr (std::is_same_v<T, Image>) {
    return Image{1, 2, 3, {4, 5}};
  } else if constexpr (std::is_same_v<T, NodePtr>) {
    return NodePtr(NodePtr(), reinterpret_cast<Node*>(1));  // never looked into
  } else {
    return "another";
  }
}

TYPED_TEST(SFieldTest, StartsAsX3DSays) {
  TypeParam field;
  using T = typename TypeParam::value_type;
  if constexpr (std::is_arithmetic_v<T>) {
    EXPECT_EQ(field.getValue(), T{});
  } else if constexpr (requires { T::Zero(); }) {
    EXPECT_EQ(field.getValue(), T::Zero());
  } else {
    EXPECT_EQ(field.getValue(), T{});
  }
  EXPECT_TRUE(field.isUpToDate());
}

TYPED_TEST(SFieldTest, CarriesItsValueAlongARoute) {
  TypeParam a, b;
  const auto value = another<typename TypeParam::value_type>();
  a.route(b);
  a.setValue(value);
  EXPECT_TRUE(b.getValue() == value);
}

TYPED_TEST(SFieldTest, SendsEvenWhatIsEqualButNotIfOnlyChangesCount) {
  TypeParam a, b;
  const auto value = another<typename TypeParam::value_type>();
  a.route(b);
  b.upToDate();
  a.setValueIfChanged(value);
  EXPECT_FALSE(b.isUpToDate());
  b.upToDate();
  a.setValueIfChanged(value);
  EXPECT_TRUE(b.isUpToDate());
  a.setValue(value);
  EXPECT_FALSE(b.isUpToDate());
}

TYPED_TEST(SFieldTest, KnowsItsType) {
  TypeParam field;
  EXPECT_EQ(field.getType(), TypeParam::kFieldType);
  EXPECT_EQ(field.getTypeName().substr(0, 2), "SF");
  EXPECT_FALSE(isMulti(field.getType()));
}

TEST(SField, SetIfChangedComparesWithWhatIsPending) {
  SFInt32 a, b, c;
  a.route(b);
  b.route(c);
  a.setValue(3);
  c.upToDate();
  a.setValue(4);
  b.setValueIfChanged(4);
  EXPECT_EQ(c.getValue(), 4);
  a.setValue(5);
  b.setValueIfChanged(4);
  EXPECT_EQ(c.getValue(), 4);
}

TEST(SField, TakesItsOwnValue) {
  SFString field;
  field.setValue("lung");
  field.setValue(field.getValue());
  EXPECT_EQ(field.getValue(), "lung");
}

TEST(SField, MovesAStringIn) {
  SFString field;
  std::string text(100, 'x');
  const char* data = text.data();
  field.setValue(std::move(text));
  EXPECT_EQ(field.getValue().data(), data);
}

TEST(FieldNames, AreX3Ds) {
  EXPECT_EQ(name(FieldType::SFBool), "SFBool");
  EXPECT_EQ(name(FieldType::MFBool), "MFBool");
  EXPECT_EQ(name(FieldType::SFColorRGBA), "SFColorRGBA");
  EXPECT_EQ(name(FieldType::SFMatrix4d), "SFMatrix4d");
  EXPECT_EQ(name(FieldType::MFVec4f), "MFVec4f");
  EXPECT_EQ(singleOf(FieldType::MFVec4f), FieldType::SFVec4f);
  EXPECT_EQ(singleOf(FieldType::SFNode), FieldType::SFNode);
}

}  // namespace
}  // namespace pleura
