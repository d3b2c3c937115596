#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/errors.h>
#include <pleura/fields/field_types.h>
#include <pleura/tests/fields/test_owner.h>

namespace pleura {
namespace {

using testing::HasSubstr;

class AccessTest : public testing::Test {
 protected:
  TestOwner owner_, stranger_;
  SFFloat free_;

  static FieldDeclaration declare(Access access) {
    FieldDeclaration declaration;
    declaration.name = "angle";
    declaration.type = FieldType::SFFloat;
    declaration.access = access;
    return declaration;
  }
  template <class F>
  void attach(F& field, const FieldDeclaration& declaration) {
    field.attach(&owner_, &declaration);
  }

  const FieldDeclaration inputOnly_ = declare(Access::inputOnly);
  const FieldDeclaration outputOnly_ = declare(Access::outputOnly);
  const FieldDeclaration initializeOnly_ = declare(Access::initializeOnly);
  const FieldDeclaration inputOutput_ = declare(Access::inputOutput);
};

TEST_F(AccessTest, InputOutputIsOpenToAll) {
  SFFloat field;
  attach(field, inputOutput_);
  field.setValue(1);
  EXPECT_EQ(field.getValue(), 1);
  field.route(free_);
  free_.route(field);
}

TEST_F(AccessTest, InputOnlyIsReadByItsOwnerOnly) {
  SFFloat field;
  attach(field, inputOnly_);
  field.setValue(2);
  EXPECT_THROW(field.getValue(), FieldAccessError);
  EXPECT_THROW(field.getValue(&stranger_), FieldAccessError);
  EXPECT_EQ(field.getValue(&owner_), 2);
}

TEST_F(AccessTest, OutputOnlyIsSetByItsOwnerOnly) {
  SFFloat field;
  attach(field, outputOnly_);
  field.setValue(2, &owner_);
  EXPECT_THROW(field.setValue(3), FieldAccessError);
  EXPECT_THROW(field.setValue(3, &stranger_), FieldAccessError);
  EXPECT_THROW(field.setValueIfChanged(2), FieldAccessError);
  EXPECT_THROW(field.setValueFromString("3"), FieldAccessError);
  EXPECT_EQ(field.getValue(), 2);
  EXPECT_TRUE(field.isUpToDate());
}

TEST_F(AccessTest, EveryEditOfAnOutputOnlyMFieldIsRefused) {
  MFFloat field;
  attach(field, outputOnly_);
  const std::vector<float> values = {1, 2};
  field.setValue(values, &owner_);
  std::vector<float> other;
  EXPECT_THROW(field.setValue(values), FieldAccessError);
  EXPECT_THROW(field.setValue({3}), FieldAccessError);
  EXPECT_THROW(field.setValue(0, 3), FieldAccessError);
  EXPECT_THROW(field.push_back(3), FieldAccessError);
  EXPECT_THROW(field.resize(3), FieldAccessError);
  EXPECT_THROW(field.clear(), FieldAccessError);
  EXPECT_THROW(field.swap(other), FieldAccessError);
  EXPECT_THROW(field.erase(1), FieldAccessError);
  EXPECT_THROW(field.setValueFromString("3"), FieldAccessError);
  EXPECT_EQ(field.getValue(), values);
}

TEST_F(AccessTest, InitializeOnlyIsClosedByClosingIt) {
  SFFloat field;
  attach(field, initializeOnly_);
  field.setValue(1);
  field.setAccessType(Access::outputOnly);
  EXPECT_THROW(field.setValue(2), FieldAccessError);
  field.setValue(3, &owner_);
  EXPECT_EQ(field.getValue(), 3);
}

TEST_F(AccessTest, RoutesRespectAccess) {
  SFFloat in, out, once;
  attach(in, inputOnly_);
  attach(out, outputOnly_);
  attach(once, initializeOnly_);
  out.route(in);
  EXPECT_THROW(in.route(free_), RouteError);
  EXPECT_THROW(free_.route(out), RouteError);
  EXPECT_THROW(free_.route(once), RouteError);
  EXPECT_TRUE(free_.getRoutesOut().empty());
  EXPECT_TRUE(out.getRoutesIn().empty());
  EXPECT_TRUE(once.getRoutesIn().empty());
  EXPECT_TRUE(in.getRoutesOut().empty());
  EXPECT_TRUE(free_.isUpToDate());
}

TEST_F(AccessTest, OwnerRoutesItsFieldsFreely) {
  SFFloat in, out;
  attach(in, inputOnly_);
  attach(out, outputOnly_);
  in.route(out, &owner_);
  in.setValue(4);
  EXPECT_EQ(out.getValue(), 4);
  EXPECT_THROW(in.route(free_, &stranger_), RouteError);
}

TEST_F(AccessTest, ErrorNamesNodeAndField) {
  SFFloat field;
  attach(field, outputOnly_);
  try {
    field.setValue(1);
    FAIL() << "no error";
  } catch (const FieldAccessError& error) {
    EXPECT_THAT(error.what(), HasSubstr("RIB.angle is outputOnly"));
  }
  try {
    free_.route(field);
    FAIL() << "no error";
  } catch (const RouteError& error) {
    EXPECT_THAT(error.what(), HasSubstr("SFFloat TO RIB.angle"));
  }
}

TEST_F(AccessTest, NamesAreX3Ds) {
  EXPECT_EQ(name(Access::inputOnly), "inputOnly");
  EXPECT_EQ(name(Access::outputOnly), "outputOnly");
  EXPECT_EQ(name(Access::initializeOnly), "initializeOnly");
  EXPECT_EQ(name(Access::inputOutput), "inputOutput");
}

}  // namespace
}  // namespace pleura
