#include <gtest/gtest.h>

#include <pleura/x3d/encoding/xml_text.h>

namespace pleura {
namespace {

TEST(XmlText, WhatWouldEndOrMarkUpIsAReference) {
  EXPECT_EQ(xmlText("a < b & c"), "a &lt; b &amp; c");
  EXPECT_EQ(xmlText("one\n\ttwo\r"), "one&#10;&#9;two&#13;");
  EXPECT_EQ(xmlText(""), "");
}

TEST(XmlText, OnlyTheQuoteAroundItIsAReference) {
  EXPECT_EQ(xmlText("it's \"so\""), "it&apos;s \"so\"");
  EXPECT_EQ(xmlText("it's \"so\"", '"'), "it's &quot;so&quot;");
}

}  // namespace
}  // namespace pleura
