#include <bit>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/field_types.h>
#include <pleura/tests/fields/test_owner.h>

namespace pleura {
namespace {

using testing::HasSubstr;

/// Random values of every type; of numbers every finite bit pattern.
class RandomValue {
 public:
  explicit RandomValue(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

  void make(bool& value) { value = below(2) == 1; }
  void make(std::int32_t& value) { value = static_cast<std::int32_t>(random_()); }
  void make(float& value) {
    do value = std::bit_cast<float>(static_cast<std::uint32_t>(random_()));
    while ((std::bit_cast<std::uint32_t>(value) & 0x7f800000U) == 0x7f800000U);
  }
  void make(double& value) {
    do value = std::bit_cast<double>(static_cast<std::uint64_t>(random_()));
    while ((std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ffU) == 0x7ffU);
  }
  void make(std::string& value) {
    constexpr char kLetters[] = "ab\"\\ \n\t',&<\xc3\xa9";
    value.clear();
    for (std::size_t i = below(12); i > 0; --i) value += kLetters[below(sizeof kLetters - 1)];
  }
  void make(Rotation& value) {
    make(value.axis);
    make(value.angle);
  }
  void make(Image& value) {
    value.width = static_cast<int>(below(4));
    value.height = static_cast<int>(below(4));
    value.components = static_cast<int>(below(5));
    value.pixels.resize(static_cast<std::size_t>(value.width) * value.height);
    for (auto& pixel : value.pixels) pixel = static_cast<std::uint32_t>(random_());
  }
  void make(NodePtr& value) { value = nullptr; }
  template <class Scalar, int Rows, int Columns>
  void make(Eigen::Matrix<Scalar, Rows, Columns>& value) {
    for (auto& each : value.reshaped()) make(each);
  }
  template <class T>
  void make(std::vector<T>& values) {
    values.clear();
    for (std::size_t i = below(6); i > 0; --i) {
      T each{};
      make(each);
      values.push_back(each);
    }
  }

 private:
  std::mt19937_64 random_;
};

template <class F>
class FieldText : public testing::Test {};

using AllFields =
    testing::Types<SFBool, MFBool, SFColor, MFColor, SFColorRGBA, MFColorRGBA, SFDouble, MFDouble, SFFloat,
                   MFFloat, SFImage, MFImage, SFInt32, MFInt32, SFMatrix3d, MFMatrix3d, SFMatrix3f,
                   MFMatrix3f, SFMatrix4d, MFMatrix4d, SFMatrix4f, MFMatrix4f, SFNode, MFNode, SFRotation,
                   MFRotation, SFString, MFString, SFTime, MFTime, SFVec2d, MFVec2d, SFVec2f, MFVec2f,
                   SFVec3d, MFVec3d, SFVec3f, MFVec3f, SFVec4d, MFVec4d, SFVec4f, MFVec4f>;
TYPED_TEST_SUITE(FieldText, AllFields);

TYPED_TEST(FieldText, ReadsBackWhatItPrints) {
  RandomValue random(1);
  TypeParam from, to;
  for (int i = 0; i < 200; ++i) {
    typename TypeParam::value_type value;
    random.make(value);
    from.setValue(value);
    const std::string text = from.getValueAsString();
    to.setValueFromString(text);
    ASSERT_TRUE(to.getValue() == value) << text;
    ASSERT_EQ(to.getValueAsString(), text);
  }
}

/// Whatever the text, it is read or refused with a place inside it, and a refused one changes nothing.
TYPED_TEST(FieldText, DamagedIsReadOrRefusedInFull) {
  RandomValue random(2);
  TypeParam field, target;
  field.routeNoEvent(target);
  for (int i = 0; i < 500; ++i) {
    typename TypeParam::value_type value;
    random.make(value);
    field.setValue(value);
    std::string text = field.getValueAsString();
    for (std::size_t n = random.below(3) + 1; n > 0 && !text.empty(); --n)
      text[random.below(text.size())] = " ,.-+eE019xX\"\\tN\0"[random.below(17)];
    target.upToDate();
    const std::string before = field.getValueAsString();
    try {
      field.setValueFromString(text);
      EXPECT_FALSE(target.isUpToDate());
      const std::string printed = field.getValueAsString();
      field.setValueFromString(printed);
      ASSERT_EQ(field.getValueAsString(), printed);
    } catch (const FieldParseError& error) {
      ASSERT_LE(error.offset, text.size());
      ASSERT_STRNE(error.what(), "");
      ASSERT_EQ(field.getValueAsString(), before);
      ASSERT_TRUE(target.isUpToDate());
    }
  }
}

template <class F>
std::string reprinted(const char* text) {
  F field;
  field.setValueFromString(text);
  return field.getValueAsString();
}

TEST(Text, WhiteSpaceAndCommasSeparate) {
  EXPECT_EQ(reprinted<MFVec2f>(" 1\t2,\n3 4 ,\r\n"), "1 2 3 4");
  EXPECT_EQ(reprinted<SFVec3f>("\n1 2 3 "), "1 2 3");
  EXPECT_EQ(reprinted<MFFloat>(" , "), "");
  EXPECT_EQ(reprinted<MFBool>("true, FALSE TRUE false"), "true false true false");
}

TEST(Text, NumbersAreC) {
  EXPECT_EQ(reprinted<MFFloat>("+1 -2. .5 1e3 1E-2 +.5e+1"), "1 -2 0.5 1000 0.01 5");
  EXPECT_EQ(reprinted<MFInt32>("+7 -2147483648 2147483647"), "7 -2147483648 2147483647");
}

/// What others write from doubles, 6e-50 for a zero.
TEST(Text, NumberTooSmallForAFloatIsZero) {
  EXPECT_EQ(reprinted<MFFloat>("6e-50 -6e-50 +1e-60"), "0 -0 0");
  EXPECT_EQ(reprinted<SFFloat>("1e-45"), "1e-45");
}

TEST(Text, MatricesAreRowByRow) {
  SFMatrix3f field;
  field.setValueFromString("1 2 3 4 5 6 7 8 9");
  EXPECT_EQ(field.getValue()(0, 2), 3);
  EXPECT_EQ(field.getValue()(2, 0), 7);
}

TEST(Text, StringsKnowTwoEscapes) {
  MFString field;
  field.setValueFromString(R"("a\"b" "c\\" "\n" "", "é")");
  EXPECT_EQ(field.getValue(), (std::vector<std::string>{"a\"b", "c\\", "\\n", "", "é"}));
  SFString single;
  single.setValueFromString(R"( as "is" )");
  EXPECT_EQ(single.getValue(), R"( as "is" )");
}

TEST(Text, AListWithoutQuotesIsOneString) {
  EXPECT_EQ(reprinted<MFString>(" left rib"), "\" left rib\"");
  EXPECT_EQ(reprinted<MFString>(" ,\n"), "");
}

TEST(Text, PixelsAreDecimalOrHexadecimal) {
  SFImage field;
  field.setValueFromString("1 3 4 0xff00FF80 255 0X0");
  EXPECT_EQ(field.getValue().pixels, (std::vector<std::uint32_t>{0xff00ff80, 255, 0}));
}

TEST(Text, ScaleTurnsAFilesUnitIntoOurs) {
  MFVec3f millimetres;
  millimetres.setValueFromString("1000 0 -500", nullptr, 0.001);
  EXPECT_EQ(millimetres.getValueAsString(), "1 0 -0.5");
  SFRotation turn;
  turn.setValueFromString("0 0 2 4", nullptr, 0.5);
  EXPECT_EQ(turn.getValueAsString(), "0 0 2 2") << "of a rotation the angle only";
  MFInt32 count;
  count.setValueFromString("3", nullptr, 0.5);
  EXPECT_EQ(count.getValueAsString(), "3");
}

struct Bad {
  FieldType type;
  const char* text;
  std::size_t offset;
  const char* expected;
};

class BadText : public testing::TestWithParam<Bad> {};

template <class F>
void expectRefused(const Bad& bad, double scale = 1) {
  F field;
  if (field.getType() != bad.type) return;
  try {
    field.setValueFromString(bad.text, nullptr, scale);
    FAIL() << "no error for " << bad.text;
  } catch (const FieldParseError& error) {
    EXPECT_EQ(error.offset, bad.offset) << bad.text;
    EXPECT_THAT(error.what(), HasSubstr(bad.expected)) << bad.text;
  }
}

template <class... Fields>
void expectRefused(const Bad& bad, testing::Types<Fields...>*) {
  (expectRefused<Fields>(bad), ...);
}

TEST_P(BadText, IsRefusedAtItsPlace) { expectRefused(GetParam(), static_cast<AllFields*>(nullptr)); }

INSTANTIATE_TEST_SUITE_P(Of, BadText,
                         testing::Values(Bad{FieldType::SFFloat, "", 0, "finite number"},
                                         Bad{FieldType::SFFloat, "1 2", 2, "nothing more"},
                                         Bad{FieldType::SFFloat, " nan", 1, "finite number"},
                                         Bad{FieldType::SFFloat, "-inf", 0, "finite number"},
                                         Bad{FieldType::SFFloat, "1e39", 0, "finite number"},
                                         Bad{FieldType::SFFloat, "1e400", 0, "finite number"},
                                         Bad{FieldType::SFDouble, "1e400", 0, "finite number"},
                                         Bad{FieldType::SFFloat, "+-5", 0, "finite number"},
                                         Bad{FieldType::SFFloat, "++5", 0, "finite number"},
                                         Bad{FieldType::SFFloat, "+", 0, "finite number"},
                                         Bad{FieldType::SFFloat, "0x10", 0, "finite number"},
                                         Bad{FieldType::SFFloat, "1m", 0, "finite number"},
                                         Bad{FieldType::SFInt32, "1.5", 0, "32 bits"},
                                         Bad{FieldType::SFInt32, "2147483648", 0, "32 bits"},
                                         Bad{FieldType::SFBool, "yes", 0, "true or false"},
                                         Bad{FieldType::SFBool, "trueish", 0, "true or false"},
                                         Bad{FieldType::MFBool, "true 1", 5, "true or false"},
                                         Bad{FieldType::SFVec3f, "1 2", 3, "3 numbers"},
                                         Bad{FieldType::MFVec3f, "1 2 3 4 x 6", 8, "finite number"},
                                         Bad{FieldType::SFMatrix3d, "1 2 3 4 5 6 7 8", 15, "9 numbers"},
                                         Bad{FieldType::SFRotation, "0 0 1", 5, "4 numbers"},
                                         Bad{FieldType::MFString, "\"a\" b", 4, "double quotes"},
                                         Bad{FieldType::MFString, " \"a", 1, "closing double quote"},
                                         Bad{FieldType::MFString, "\"a\\\"", 0, "closing double quote"},
                                         Bad{FieldType::SFVec3f, "1 2 3 x", 6, "nothing more after 3"},
                                         Bad{FieldType::SFImage, "2 2 3 1 2 3", 11, "32 bits"},
                                         Bad{FieldType::SFImage, "2147483647 2147483647 1", 23, "pixels"},
                                         Bad{FieldType::SFImage, "-1 0 0", 6, "width, height"},
                                         Bad{FieldType::SFImage, "0 0 5", 5, "components"},
                                         Bad{FieldType::SFImage, "1 1 1 0xg", 6, "hexadecimal"},
                                         Bad{FieldType::SFImage, "1 1 1 0x1ffffffff", 6, "hexadecimal"},
                                         Bad{FieldType::SFNode, "Rib", 0, "node element"},
                                         Bad{FieldType::MFNode, "NULL NULLNULL", 5, "node element"}));

template <class F>
std::string refusal(std::size_t numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers; ++i) text += "1 ";
  F field;
  try {
    field.setValueFromString(text);
  } catch (const FieldParseError& error) {
    return error.what() + std::string(", found ") + error.found;
  }
  return "";
}

template <class Single, class List>
void expectCounted(std::size_t n) {
  const std::string each = std::to_string(n), less = std::to_string(n - 1), more = std::to_string(n + 1);
  SCOPED_TRACE(Single().getTypeName());
  EXPECT_EQ(refusal<Single>(0), each + " numbers, found 0");
  EXPECT_EQ(refusal<Single>(n - 1), each + " numbers, found " + less);
  EXPECT_EQ(refusal<Single>(n), "");
  EXPECT_EQ(refusal<Single>(n + 1), "nothing more after " + each + " numbers, found ");
  EXPECT_EQ(refusal<List>(n - 1), each + " numbers, found " + less);
  EXPECT_EQ(refusal<List>(2 * n), "");
  EXPECT_EQ(refusal<List>(n + 1), "a multiple of " + each + " numbers, found " + more);
}

TEST(BadTextOf, TooFewOrTooManyNumbersAreCounted) {
  expectCounted<SFColor, MFColor>(3);
  expectCounted<SFColorRGBA, MFColorRGBA>(4);
  expectCounted<SFMatrix3d, MFMatrix3d>(9);
  expectCounted<SFMatrix3f, MFMatrix3f>(9);
  expectCounted<SFMatrix4d, MFMatrix4d>(16);
  expectCounted<SFMatrix4f, MFMatrix4f>(16);
  expectCounted<SFRotation, MFRotation>(4);
  expectCounted<SFVec2d, MFVec2d>(2);
  expectCounted<SFVec2f, MFVec2f>(2);
  expectCounted<SFVec3d, MFVec3d>(3);
  expectCounted<SFVec3f, MFVec3f>(3);
  expectCounted<SFVec4d, MFVec4d>(4);
  expectCounted<SFVec4f, MFVec4f>(4);
}

TEST(BadTextOf, AScaledNumberThatIsTooLargeIsRefused) {
  expectRefused<SFFloat>({FieldType::SFFloat, "3e38", 0, "finite number"}, 1000);
  expectRefused<SFDouble>({FieldType::SFDouble, "-1e308", 0, "finite number"}, 1000);
}

TEST(BadTextOf, ANumberOutOfTheDeclaredRangeIsRefusedAtItsPlace) {
  TestOwner owner;
  FieldDeclaration declaration;
  declaration.minimum = 0;
  declaration.maximum = 1;
  MFVec2f field;
  field.attach(&owner, &declaration);
  field.setValueFromString("0 1 0.5 0.5");
  try {
    field.setValueFromString("0 1  0.5 1.5");
    FAIL() << "no error";
  } catch (const FieldParseError& error) {
    EXPECT_EQ(error.offset, 5U);
    EXPECT_STREQ(error.what(), "0 to 1");
  }
  EXPECT_EQ(field.getValueAsString(), "0 1 0.5 0.5");
}

}  // namespace
}  // namespace pleura
