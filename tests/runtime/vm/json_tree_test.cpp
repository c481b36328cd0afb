#include "vm/json_tree.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirada::vm {
namespace {

TEST(JsonTree, GivesWhatTheTextSays) {
  const JsonTree tree = JsonTree::parse(R"({"b":[1,"x\u00e9",true,null,{"in":-2.5}],"a":{}})");
  ASSERT_FALSE(tree.broken());
  const JsonValue list = tree.root().find("b");
  ASSERT_EQ(list.size(), 5U);
  EXPECT_EQ(list[0].number(), 1);
  EXPECT_EQ(list[1].text(), "x\u00e9");
  EXPECT_TRUE(list[2].truth());
  EXPECT_TRUE(list[3].is_null());
  EXPECT_EQ(list[4].find("in").number(), -2.5);
  EXPECT_EQ(list[4].find("in").key(), "in");
  EXPECT_TRUE(tree.root().find("a").is_object());
}

TEST(JsonTree, AsATextZeroKeepsItsSign) {
  const JsonTree tree = JsonTree::parse(R"([-0.0,0,-0,-0.5])");
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < tree.root().size(); ++i) texts.push_back(plain_text(tree.root()[i]));
  EXPECT_EQ(texts, (std::vector<std::string>{"-0", "0", "-0", "-0.5"}));
}

TEST(JsonTree, WhatIsNotThereIsNothingAndHasNoParts) {
  const JsonTree tree = JsonTree::parse(R"({"a":{"f":1},"l":[1]})");
  const JsonValue root = tree.root();
  EXPECT_FALSE(root.find("b"));
  EXPECT_FALSE(root.find("b").find("c")[3]);
  EXPECT_FALSE(root.find("a")[0]);
  EXPECT_FALSE(root.find("l")[1]);
  EXPECT_TRUE(root.find("b").is_null());
  EXPECT_TRUE(root.find("b").fields().empty());
}

TEST(JsonTree, OfTwoFieldsWithOneNameTheLastCounts) {
  const JsonTree tree = JsonTree::parse(R"({"z":1,"a":2,"z":3,"a":4})");
  EXPECT_EQ(tree.root().find("z").number(), 3);
  const std::vector<JsonValue> fields = tree.root().fields();
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(fields[0].number(), 4);
  EXPECT_EQ(fields[1].number(), 3);
}

TEST(JsonTree, ReadsEveryWayToWriteALetter) {
  const JsonTree tree =
      JsonTree::parse(R"(["\"\\\/\b\f\n\r\t","\u00e9\uD83D\uDE00","é😀","\ud83d!","\ude00\u0041"])");
  ASSERT_FALSE(tree.broken());
  EXPECT_EQ(tree.root()[0].text(), "\"\\/\b\f\n\r\t");
  EXPECT_EQ(tree.root()[1].text(), "é😀");
  EXPECT_EQ(tree.root()[2].text(), "é😀");
  EXPECT_EQ(tree.root()[3].text(), "\ufffd!");
  EXPECT_EQ(tree.root()[4].text(), "\ufffdA");
}

TEST(JsonTree, ReadsNumbersAndSpaces) {
  const JsonTree tree = JsonTree::parse(" [ -0 , 0.5,\n12e-1\t,1E+3, 1e-999 ] \r\n");
  ASSERT_FALSE(tree.broken());
  const double wanted[] = {0, 0.5, 1.2, 1000, 0};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(tree.root()[i].number(), wanted[i]) << i;
}

/// The parser that the rest of the house uses takes and refuses the same.
TEST(JsonTree, RefusesWhatIsNoJson) {
  for (const char* text : {"",
                           " ",
                           "{",
                           "[",
                           "]",
                           "[1",
                           "[1,",
                           "[1,]",
                           "[,1]",
                           "{\"a\"}",
                           "{\"a\":}",
                           "{\"a\":1,}",
                           "{a:1}",
                           "[1 2]",
                           "{\"a\":1]",
                           "[1}",
                           "01",
                           "1.",
                           ".5",
                           "+1",
                           "-",
                           "1e",
                           "1e+",
                           "0x1",
                           "nul",
                           "truE",
                           "\"",
                           "\"a",
                           "\"\\\"",
                           "\"\\x\"",
                           "\"\\u12g4\"",
                           "\"\n\"",
                           "\"\xff\"",
                           "\"\xc0\x80\"",
                           "\"\xed\xa0\x80\"",
                           "\"\xf4\x90\x80\x80\"",
                           "\"\xe2\x82\"",
                           "1 1",
                           "[] []",
                           "NaN",
                           "Infinity",
                           "'a'",
                           "/**/1"}) {
    EXPECT_TRUE(JsonTree::parse(text).broken()) << text;
    EXPECT_FALSE(nlohmann::json::accept(text)) << text;
  }
  EXPECT_TRUE(JsonTree::parse(std::string_view("1\0", 2)).broken());
}

TEST(JsonTree, SaysWhereATextIsNoJson) {
  EXPECT_EQ(JsonTree::parse(R"({"a":)").broken()->byte, 6U);
  EXPECT_TRUE(JsonTree::parse("[1e999]").broken()->number_too_large);
  EXPECT_TRUE(JsonTree::parse("").broken());
  EXPECT_FALSE(JsonTree::parse("").root());
}

TEST(JsonTree, DepthDoesNotMatter) {
  constexpr std::size_t kDepth = 200'000;
  const JsonTree tree = JsonTree::parse(std::string(kDepth, '[') + std::string(kDepth, ']'));
  ASSERT_FALSE(tree.broken());
  JsonValue at = tree.root();
  std::size_t depth = 1;
  for (; at.size() == 1; at = at[0]) ++depth;
  EXPECT_EQ(depth, kDepth);
}

}  // namespace
}  // namespace mirada::vm
