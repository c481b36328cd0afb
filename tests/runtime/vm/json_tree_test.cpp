#include "vm/json_tree.h"

#include <gtest/gtest.h>

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
