#include <gtest/gtest.h>

#include "vm/text.h"

namespace mirada::vm {
namespace {

std::optional<bool> holds(const std::string& whole, const std::string& part, bool hurry = false) {
  Heap heap;
  const std::atomic<bool> give_up{hurry};
  return contains_text(*make_text(heap, std::string_view(whole)).text(),
                       *make_text(heap, std::string_view(part)).text(), give_up);
}

TEST(ContainsText, FindsPartsInWhateverCase) {
  EXPECT_EQ(holds("Mirada", "IRA"), true);
  EXPECT_EQ(holds("Mirada", "mirada"), true);
  EXPECT_EQ(holds("Mirada", "miradas"), false);
  EXPECT_EQ(holds("", ""), true);
  EXPECT_EQ(holds("\u00d1and\u00fa", "\u00f1AND\u00da"), true);
}

TEST(ContainsText, CaseIsJavaScripts) {
  EXPECT_EQ(holds("\u0130stanbul", "i\u0307s"), true);
  EXPECT_EQ(holds("\u0130", "i"), true);
  EXPECT_EQ(holds("\u039b\u039f\u0393\u039f\u03a3 A", "\u03bf\u03c2 a"), true);
  EXPECT_EQ(holds("\u03a3\u0391", "\u03c2"), false);
  EXPECT_EQ(holds("\U00010400", "\U00010428"), true);
}

TEST(ContainsText, PartsThatBeginLikeThemselvesAreFound) {
  EXPECT_EQ(holds("aabaabaaab", "aabaaab"), true);
  EXPECT_EQ(holds("abababac", "ababac"), true);
  EXPECT_EQ(holds("abababab", "ababac"), false);
}

TEST(ContainsText, IsLinear) {
  const std::string part = "b" + std::string(500'000, 'a');
  EXPECT_EQ(holds(std::string(2'000'000, 'a'), part), false);
}

TEST(ContainsText, GivesUpWhenAsked) {
  EXPECT_EQ(holds(std::string(200'000, 'a'), "ab", true), std::nullopt);
}

}  // namespace
}  // namespace mirada::vm
