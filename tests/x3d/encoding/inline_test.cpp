#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/standard/navigation/x3d_viewpoint_node.h>
#include <pleura/tests/x3d/encoding/read_scene.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kPart =
    "<Scene><Transform DEF='INNER' translation='1 2 3'/><EXPORT localDEF='INNER' AS='PART'/></Scene>";

/// A scene in a folder of its own, with a part below it and one outside.
class Inlines : public testing::Test {
 protected:
  ReadScene read(const std::string& elements, const ReaderLimits& limits = {}) {
    return ReadScene(folder_.write("scene/s.x3d", "<Scene>" + elements + "</Scene>"), limits);
  }

  TemporaryFolder folder_;
  std::filesystem::path inside_ = folder_.write("scene/parts/part.x3d", kPart);
  std::filesystem::path outside_ = folder_.write("outside.x3d", kPart);
};

TEST_F(Inlines, ImportBringsAnExportedNodeAndRoutesReachIt) {
  auto scene = read(
      "<Inline DEF='I' url='\"parts/part.x3d\"'/><Transform DEF='T'/>"
      "<IMPORT inlineDEF='I' importedDEF='PART' AS='P'/>"
      "<ROUTE fromNode='P' fromField='translation' toNode='T' toField='translation'/>");
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(scene.value("T", "translation"), "1 2 3");
}

TEST_F(Inlines, WithoutAsTheImportKeepsItsName) {
  auto scene = read("<Inline DEF='I' url='\"parts/part.x3d\"'/><IMPORT inlineDEF='I' importedDEF='PART'/>");
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(scene.document.names.count("PART"), 1u);
}

TEST_F(Inlines, NamesThatAreNotImportedStayInside) {
  auto scene = read("<Inline DEF='I' url='\"parts/part.x3d\"'/>");
  EXPECT_EQ(scene.document.names.count("INNER"), 0u);
  EXPECT_EQ(scene.document.names.count("PART"), 0u);
}

TEST_F(Inlines, ImportOfWhatIsNotExportedNamesTheNearest) {
  auto scene = read("<Inline DEF='I' url='\"parts/part.x3d\"'/><IMPORT inlineDEF='I' importedDEF='PARD'/>");
  ASSERT_EQ(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("IMPORT: I exports no PARD; did you mean PART?"));
}

TEST_F(Inlines, ImportFromNoInlineIsAnError) {
  auto scene = read("<IMPORT inlineDEF='NOWHERE' importedDEF='PART'/>");
  ASSERT_EQ(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("NOWHERE"));
}

TEST_F(Inlines, ExportedDefIsUnderstoodWithAWarning) {
  auto scene =
      read("<Inline DEF='I' url='\"parts/part.x3d\"'/><IMPORT inlineDEF='I' exportedDEF='PART' AS='P'/>");
  EXPECT_EQ(scene.diagnostics.errors(), 0u);
  ASSERT_EQ(scene.diagnostics.warnings(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("importedDEF"));
  EXPECT_EQ(scene.document.names.count("P"), 1u);
}

TEST_F(Inlines, OutsideTheFolderIsRefused) {
  for (const std::string& url :
       {std::string("../outside.x3d"), outside_.string(), std::string("parts/../../outside.x3d")}) {
    auto scene = read("<Inline DEF='I' url='\"" + url + "\"'/>");
    ASSERT_EQ(scene.diagnostics.errors(), 1u) << url;
    EXPECT_THAT(scene.said()[0],
                HasSubstr("s.x3d:1:29: error: I.url: " + url + " is outside the scene's folder"));
  }
}

TEST_F(Inlines, ALinkOutOfTheFolderIsRefused) {
  std::filesystem::create_symlink(outside_, folder_.path() / "scene/link.x3d");
  EXPECT_EQ(read("<Inline DEF='I' url='\"link.x3d\"'/>").diagnostics.errors(), 1u);
}

TEST_F(Inlines, OutsideTheFolderIsReadWhereTheLimitsAllowIt) {
  ReaderLimits limits;
  limits.outsideFolder = true;
  auto scene =
      read("<Inline DEF='I' url='\"../outside.x3d\"'/><IMPORT inlineDEF='I' importedDEF='PART'/>", limits);
  EXPECT_THAT(scene.said(), IsEmpty());
}

TEST_F(Inlines, AnatomyMayStandElsewhere) {
  folder_.write("elsewhere/part.x3d", kPart);
  ReaderLimits limits;
  limits.anatomyFolder = folder_.path() / "elsewhere";
  auto scene =
      read("<Inline DEF='I' url='\"anatomy/part.x3d\"'/><IMPORT inlineDEF='I' importedDEF='PART'/>", limits);
  EXPECT_THAT(scene.said(), IsEmpty());
}

TEST_F(Inlines, TheFirstUrlThatIsThereIsLoaded) {
  auto scene = read(
      "<Inline DEF='I' url='\"none.x3d\" \"https://example.org/a.x3d\" \"parts/part.x3d\"'/>"
      "<IMPORT inlineDEF='I' importedDEF='PART'/>");
  EXPECT_THAT(scene.said(), IsEmpty());
}

TEST_F(Inlines, NothingToLoadIsAnErrorThatTellsWhatWasTried) {
  auto scene = read("<Inline DEF='I' url='\"none.x3d\" \"nor_this.x3d\"'/>");
  ASSERT_EQ(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("none.x3d, nor_this.x3d not found"));
}

TEST_F(Inlines, NotLoadedWhereTheFileSaysSo) {
  auto scene = read("<Inline load='false' url='\"none.x3d\"'/>");
  EXPECT_THAT(scene.said(), IsEmpty());
}

TEST_F(Inlines, AFileThatInlinesItselfIsAnError) {
  auto scene = read("<Inline DEF='I' url='\"s.x3d\"'/>");
  ASSERT_EQ(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("inlines itself"));
}

TEST_F(Inlines, TwoFilesThatInlineEachOtherAreAnError) {
  folder_.write("scene/b.x3d", "<Scene><Inline url='\"s.x3d\"'/></Scene>");
  auto scene = read("<Inline url='\"b.x3d\"'/>");
  ASSERT_EQ(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("b.x3d:1:"));
}

TEST_F(Inlines, AChainOfFilesEnds) {
  for (int i = 0; i < 40; ++i)
    folder_.write("scene/c" + std::to_string(i) + ".x3d",
                  "<Scene><Inline url='\"c" + std::to_string(i + 1) + ".x3d\"'/></Scene>");
  auto scene = read("<Inline url='\"c0.x3d\"'/>");
  ASSERT_EQ(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("16 files inline one another"));
}

TEST_F(Inlines, FaultsInsideHaveTheInnerFilesPlace) {
  folder_.write("scene/bad.x3d", "<Scene>\n<Sphere radius='x'/></Scene>");
  auto scene = read("<Inline url='\"bad.x3d\"'/>");
  ASSERT_EQ(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("bad.x3d:2:17: error: Sphere.radius"));
}

/// A part with a viewpoint of its own.
class InlinedViewpoints : public Inlines {
 protected:
  std::string bound(const std::string& elements) {
    scene_ = std::make_unique<ReadScene>(folder_.write("scene/s.x3d", "<Scene>" + elements + "</Scene>"));
    EXPECT_THAT(scene_->said(), IsEmpty());
    auto* top = dynamic_cast<X3DViewpointNode*>(scene_->context.bindables("Viewpoint").top());
    return top != nullptr ? top->description.getValue() : "none";
  }

  const std::string inline_ = "<Inline url='\"view.x3d\"'/>";
  const std::string own_ = "<Viewpoint description='first'/><Viewpoint description='second'/>";

 private:
  std::filesystem::path view_ =
      folder_.write("scene/view.x3d", "<Scene><Viewpoint description='of the part'/></Scene>");
  std::unique_ptr<ReadScene> scene_;
};

TEST_F(InlinedViewpoints, TheFilesOwnFirstIsBoundWhereverTheInlineStands) {
  EXPECT_EQ(bound(inline_ + own_), "first");
  EXPECT_EQ(bound(own_ + inline_), "first");
  EXPECT_EQ(bound("<Group>" + inline_ + own_ + "</Group>"), "first");
}

TEST_F(InlinedViewpoints, AreBoundWhereTheFileHasNone) { EXPECT_EQ(bound(inline_), "of the part"); }

}  // namespace
}  // namespace pleura
