#include "vm/value.h"

#include <gtest/gtest.h>

namespace mirada::vm {
namespace {

double compared(std::string_view a, std::string_view b) {
  Heap heap;
  return compare(make_text(heap, a), make_text(heap, b));
}

TEST(Value, TextsWithSurrogatesCompareTheSameBothWays) {
  const std::string grin = ".\U0001F600", beam = ".\U0001F601";
  EXPECT_EQ(compared(grin, beam), -1);
  EXPECT_EQ(compared(beam, grin), 1);
  EXPECT_EQ(compared("'\U00010400", "'\U00010428"), 0);
  EXPECT_EQ(compared("\u0301\U0001F600", "\u0301\U0001F601"), -1);
}

TEST(Value, TextsCompareInJavaScriptsLowerCase) {
  EXPECT_EQ(compared("\u00c9", "\u00e9"), 0);
  EXPECT_GT(compared("\u00e9", "\u0130"), 0);
  EXPECT_EQ(compared("\u0130", "i\u0307"), 0);
  EXPECT_EQ(compared("\u039b\u039f\u0393\u039f\u03a3", "\u03bb\u03bf\u03b3\u03bf\u03c2"), 0);
  EXPECT_EQ(compared("\u03a3", "\u03c3"), 0);
  EXPECT_EQ(compared("\u0391\u03a3'\u0391", "\u03b1\u03c3'\u03b1"), 0);
  EXPECT_EQ(compared("\U00010400", "\U00010428"), 0);
  EXPECT_NE(compared("\u0131", "I"), 0);
}

TEST(Value, SpacesOfEveryScriptMayStandAroundANumber) {
  EXPECT_EQ(number_of("5\u00a0"), 5);
  EXPECT_EQ(number_of("\u2003\ufeff-2.5\u3000"), -2.5);
  EXPECT_EQ(number_of("\u00a0"), 0);
  EXPECT_NE(number_of("5\u200b"), 5);
  EXPECT_NE(number_of("\u0665"), 5);
}

}  // namespace
}  // namespace mirada::vm
