#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <pleura/tests/x3d/encoding/read_scene.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(ReadFiles, GzipIsUnpacked) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "packed.x3dz";
  const std::string text = "<Scene><Group DEF='G'/></Scene>";
  gzFile out = gzopen(file.c_str(), "wb");
  gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
  gzclose(out);
  const ReadScene scene(file);
  EXPECT_THAT(scene.said(), IsEmpty());
  EXPECT_EQ(scene.document.names.count("G"), 1u);
}

TEST(ReadFiles, DamagedGzipIsAnError) {
  const TemporaryFolder folder;
  const ReadScene scene(
      folder.write("bad.x3dz", std::string_view("\x1f\x8b\x08\0\0\0\0\0\0\x03 not deflate", 22)));
  EXPECT_GE(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.document.nodes, IsEmpty());
}

TEST(ReadFiles, WhatIsNoSceneIsAnErrorThatNamesTheFile) {
  const TemporaryFolder folder;
  const std::filesystem::path files[] = {
      folder.path() / "missing.x3d", folder.path(), folder.write("empty.x3d", ""),
      folder.write("rubbish.x3d", std::string_view("\0\1\xff\xfe rubbish <<>>", 17)), "/dev/null"};
  for (const auto& file : files) {
    SCOPED_TRACE(file);
    const ReadScene scene(file);
    EXPECT_GE(scene.diagnostics.errors(), 1u);
    EXPECT_THAT(scene.said(), Each(HasSubstr(file.string())));
    EXPECT_THAT(scene.document.nodes, IsEmpty());
  }
}

TEST(ReadFiles, NoTextAtAllIsAnError) { EXPECT_EQ(ReadScene::ofText("").diagnostics.errors(), 1u); }

TEST(ReadFiles, ATruncatedFileIsAnErrorWhereverItEnds) {
  const std::string whole =
      "<X3D version='4.0'><Scene><Transform DEF='T' translation='1 2 3'>\n<Shape><Box/></Shape></Transform>"
      "<ROUTE fromNode='T' fromField='scale' toNode='T' toField='center'/></Scene></X3D>";
  EXPECT_THAT(ReadScene::ofText(whole).said(), IsEmpty());
  for (std::size_t length = 1; length < whole.size(); ++length)
    EXPECT_GE(ReadScene::ofText(whole.substr(0, length)).diagnostics.errors(), 1u) << whole.substr(0, length);
}

TEST(ReadFiles, EveryByteMayBeWrong) {
  const std::string whole = "<Scene><Shape DEF='S'><Box size='1 2 3'/></Shape><Shape USE='S'/></Scene>";
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char wrong : {'\0', '<', '>', '\'', '&', ' ', '\xff', 'S'}) {
      std::string text = whole;
      text[at] = wrong;
      EXPECT_LE(ReadScene::ofText(text).document.nodes.size(), 2u);
    }
}

TEST(ReadFiles, AFaultHasItsPlaceWhateverTheLineEnds) {
  for (const char* end : {"\n", "\r\n"}) {
    const auto scene = ReadScene::ofText(fmt::format("<Scene>{0}<Group{0}\tDEF='G'/>{0} <Box></Bax>", end));
    ASSERT_THAT(scene.said(), SizeIs(testing::Ge(1U)));
    EXPECT_THAT(scene.said()[0], HasSubstr("s.x3d:4:13: error: XML: Opening and ending tag mismatch"));
  }
}

TEST(ReadFiles, AFaultBelowTheLinesThatLibxmlCountsHasItsPlace) {
  const auto scene = ReadScene::ofText("<Scene>" + std::string(100'000, '\n') + "<Box></Bax></Scene>");
  EXPECT_THAT(scene.said()[0], HasSubstr("s.x3d:100001:12: "));
}

/// Each line end and each tab of an attribute is a space (XML 1.0, 3.3.3), but not one that is escaped.
TEST(ReadFiles, WhiteSpaceOfAStringIsAsXmlHasIt) {
  const auto scene = [](const std::string& title) {
    return ReadScene::ofText("<Scene><WorldInfo DEF='W' title='" + title + "'/></Scene>").value("W", "title");
  };
  EXPECT_EQ(scene("a\nb\n\nc"), "a b  c");
  EXPECT_EQ(scene("a\tb\r\nc\r\r\nd\n\re"), "a b c  d  e");
  EXPECT_EQ(scene("a&#10;b&#9;c&#13;d"), "a\nb\tc\rd");
}

/// In two bytes a character, those of a line end may be of another one: U+0A09 is a letter.
TEST(ReadFiles, Utf16KeepsItsCharacters) {
  std::string text = "\xff\xfe";
  for (const char c : std::string("<Scene><WorldInfo DEF='W' title='a\n@\tb'/></Scene>")) {
    text += c == '@' ? '\t' : c;
    text += c == '@' ? '\n' : '\0';
  }
  EXPECT_EQ(ReadScene::ofText(text).value("W", "title"), "a \xe0\xa8\x89 b");
}

TEST(ReadLimits, NoEntityBombAndNoExternalEntity) {
  std::string text = "<!DOCTYPE X3D [<!ENTITY a0 'aaaaaaaaaa'>";
  for (int i = 1; i < 30; ++i) text += fmt::format("<!ENTITY a{0} '&a{1};&a{1};&a{1};&a{1};'>", i, i - 1);
  text += "<!ENTITY passwords SYSTEM 'file:///etc/passwd'>]>";
  auto scene =
      ReadScene::ofText(text + "<Scene><WorldInfo DEF='W' title='&a29;'/><Group>&passwords;</Group></Scene>");
  for (const auto& [name, node] : scene.document.names)
    EXPECT_LT(node->getField("title")->getValueAsString().size(), 1000u);
}

TEST(ReadLimits, DeepNestingIsToldOnceAndCutOff) {
  constexpr int kDeep = 100000;
  std::string text;
  for (int i = 0; i < kDeep; ++i) text += "<Group>";
  for (int i = 0; i < kDeep; ++i) text += "</Group>";
  const auto scene = ReadScene::ofText(text);
  ASSERT_THAT(scene.said(), SizeIs(1));
  EXPECT_THAT(scene.said()[0], HasSubstr("nested more than 1000 deep"));
}

TEST(ReadLimits, UseBombIsCutOff) {
  std::string text = "<Group DEF='G0'/>";
  for (int i = 1; i < 64; ++i)
    text += fmt::format("<Group DEF='G{0}'><Group USE='G{1}'/><Group USE='G{1}'/></Group>\n", i, i - 1);
  const auto scene = ReadScene::ofElements(text);
  EXPECT_GE(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("too large or too deep"));
}

TEST(ReadLimits, DepthThroughUseIsCutOff) {
  std::string text = "<Group DEF='G0'/>";
  for (int i = 1; i < 1500; ++i)
    text += "<Group DEF='G" + std::to_string(i) + "'><Group USE='G" + std::to_string(i - 1) + "'/></Group>\n";
  const auto scene = ReadScene::ofElements(text);
  ASSERT_GE(scene.diagnostics.errors(), 1u);
  EXPECT_THAT(scene.said()[0], HasSubstr("too large or too deep"));
}

}  // namespace
}  // namespace pleura
