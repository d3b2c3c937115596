#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/auto_update.h>
#include <pleura/fields/errors.h>
#include <pleura/fields/field_types.h>
#include <pleura/fields/typed_field.h>

namespace pleura {
namespace {

using testing::HasSubstr;

/// As somebody who wrote for H3D writes it.
class MyFloat : public TypedField<SFFloat, Types<SFBool, SFFloat>> {
  void update() override {
    bool on = static_cast<SFBool*>(routes_in[0])->getValue();
    float f = static_cast<SFFloat*>(routes_in[1])->getValue();
    value = on ? f : -f;
  }
};

TEST(TypedField, OfH3DsStyleWorksAsWritten) {
  SFBool on;
  SFFloat f, out;
  MyFloat mine;
  on.route(mine);
  f.route(&mine);
  mine.route(out);
  f.setValue(3);
  EXPECT_EQ(mine.getValue(), -3);
  on.setValue(true);
  EXPECT_EQ(mine.getValue(), 3);
  EXPECT_EQ(out.getValue(), 3);
}

TEST(TypedField, ChecksEachInputAtItsPlace) {
  SFBool on;
  SFFloat f;
  SFInt32 other;
  MyFloat mine;
  EXPECT_THROW(f.route(mine), RouteError);
  on.route(mine);
  EXPECT_THROW(other.route(mine), RouteError);
  f.route(mine);
  EXPECT_EQ(mine.getRoutesIn().size(), 2U);
  EXPECT_TRUE(other.getRoutesOut().empty());
}

TEST(TypedField, RefusesOneInputTooMany) {
  SFBool on;
  SFFloat f, more;
  MyFloat mine;
  on.route(mine);
  f.route(mine);
  try {
    more.route(mine);
    FAIL() << "no error";
  } catch (const RouteError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no input number 3"));
  }
  EXPECT_TRUE(more.getRoutesOut().empty());
  f.setValue(2);
  EXPECT_EQ(mine.getValue(), -2);
}

TEST(TypedField, MissingInputIsAClearErrorAtEvaluation) {
  SFBool on;
  MyFloat mine;
  on.route(mine);
  try {
    mine.getValue();
    FAIL() << "no error";
  } catch (const MissingInputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("1 of 2 inputs"));
    EXPECT_THAT(error.what(), HasSubstr("SFFloat"));
  }
  EXPECT_FALSE(mine.isUpToDate());
  SFFloat f;
  f.route(mine);
  EXPECT_EQ(mine.getValue(), 0);
}

TEST(TypedField, MissingInputIsAnErrorAgainOnceItIsGone) {
  SFBool on;
  MyFloat mine;
  on.route(mine);
  {
    SFFloat f;
    f.route(mine);
    f.setValue(1);
    EXPECT_EQ(mine.getValue(), -1);
  }
  EXPECT_EQ(mine.getValue(), -1) << "nothing is pending";
  on.setValue(true);
  EXPECT_THROW(mine.getValue(), MissingInputError);
}

/// After unrouting the first, the second stands in its place: reading it as an SFBool would be undefined.
TEST(TypedField, InputThatMovedToAnothersPlaceIsAnError) {
  SFBool on;
  SFFloat f, g;
  MyFloat mine;
  on.route(mine);
  f.route(mine);
  on.unroute(mine);
  g.route(mine);
  try {
    mine.getValue();
    FAIL() << "no error";
  } catch (const MissingInputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("SFFloat as input number 1 where SFBool is expected"));
  }
}

class AnyOf : public TypedField<SFInt32, Types<Any<SFBool, SFInt32>>, Types<SFTime, Any<SFFloat, MFFloat>>> {
  void update() override { value = static_cast<int>(routes_in.size()); }
};

TEST(TypedField, AnyTakesEachOfItsClasses) {
  SFBool flag;
  SFInt32 number;
  SFFloat wrong;
  AnyOf a, b, c;
  flag.route(a);
  number.route(b);
  EXPECT_EQ(a.getValue(), 1);
  EXPECT_EQ(b.getValue(), 1);
  try {
    wrong.route(c);
    FAIL() << "no error";
  } catch (const RouteError& error) {
    EXPECT_THAT(error.what(), HasSubstr("SFBool or SFInt32 is expected"));
  }
}

TEST(TypedField, OptionalInputsMayFollow) {
  SFBool flag;
  SFTime time;
  SFDouble notTime;
  MFFloat many;
  SFFloat tooMany;
  AnyOf field;
  EXPECT_THROW(time.route(field), RouteError) << "the required input comes first";
  flag.route(field);
  EXPECT_EQ(field.getValue(), 1);
  EXPECT_THROW(notTime.route(field), RouteError);
  time.route(field);
  many.route(field);
  EXPECT_EQ(field.getValue(), 3);
  EXPECT_THROW(tooMany.route(field), RouteError);
}

class Total : public TypedField<SFFloat, AnyNumber<Any<SFFloat, MFFloat>>> {
  void update() override {
    float total = 0;
    for (Field* input : routes_in) {
      if (auto* one = dynamic_cast<SFFloat*>(input)) total += one->getValue();
      if (auto* many = dynamic_cast<MFFloat*>(input))
        for (const float each : many->getValue()) total += each;
    }
    value = total;
  }
};

TEST(TypedField, AnyNumberTakesAsManyAsThereAre) {
  std::vector<SFFloat> inputs(10);
  MFFloat many;
  SFInt32 wrong;
  Total total;
  EXPECT_EQ(total.getValue(), 0);
  total.touch();
  EXPECT_EQ(total.getValue(), 0);
  for (SFFloat& input : inputs) input.route(total);
  many.route(total);
  EXPECT_THROW(wrong.route(total), RouteError);
  for (SFFloat& input : inputs) input.setValue(2);
  many.setValue({10, 20});
  EXPECT_EQ(total.getValue(), 50);
}

class Bare : public TypedField<SFInt32, Any<SFBool, SFInt32>> {
  void update() override { value = static_cast<int>(routes_in.size()); }
};

TEST(TypedField, BareAnyStandsForAnyNumber) {
  SFBool a, b;
  SFInt32 c;
  Bare bare;
  a.route(bare);
  c.route(bare);
  b.route(bare);
  EXPECT_EQ(bare.getValue(), 3);
}

TEST(TypedField, SerialOptionalAnyNumber) {
  class Tail : public TypedField<SFInt32, Types<SFBool>, AnyNumber<SFInt32>> {
    void update() override { value = static_cast<int>(routes_in.size()); }
  };
  SFBool flag;
  std::vector<SFInt32> rest(5);
  Tail tail;
  flag.route(tail);
  for (SFInt32& each : rest) each.route(tail);
  EXPECT_EQ(tail.getValue(), 6);
  EXPECT_THROW(SFBool().route(tail), RouteError);
}

/// An input of a class of one's own, and a field derived from the class that is asked for.
TEST(TypedField, TakesClassesDerivedFromAnInputs) {
  class Of : public TypedField<SFFloat, Types<MyFloat>> {
    void update() override { value = static_cast<MyFloat*>(routes_in[0])->getValue() * 2; }
  };
  SFBool on;
  SFFloat f;
  MyFloat mine;
  MyFloat nested;
  Of of;
  on.route(mine);
  f.route(mine);
  EXPECT_THROW(f.route(of), RouteError);
  mine.route(of);
  on.route(nested);
  mine.route(nested);
  f.setValue(4);
  EXPECT_EQ(of.getValue(), -8);
  EXPECT_EQ(nested.getValue(), 4);
}

}  // namespace
}  // namespace pleura
