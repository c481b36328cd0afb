// Texts of digits in the bits of a NaN.
#include "vm/digits.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "vm/numbers.h"

namespace mirada::vm {
namespace {

TEST(Digits, ComeBackAsTheNumberThatTheyMean) {
  for (const char* text : {"0", "5", "-5", "0.1", "-0.25", "3.14159", "9999999999999", "-9999999999999",
                           "0.000001", "1234567.891234"}) {
    ASSERT_TRUE(is_canonical_number(text)) << text;
    const double kept = digits_of(string_to_number(text));
    EXPECT_TRUE(std::isnan(kept)) << text;
    EXPECT_TRUE(is_digits(kept)) << text;
    EXPECT_EQ(plain(kept), string_to_number(text)) << text;
    EXPECT_EQ(number_to_string(behind_digits(kept)), text);
  }
}

TEST(Digits, AreNotWhatPrintsOtherwiseOrDoesNotFit) {
  for (const char* text :
       {"", "-", ".5", "5.", "05", "-0", "1e3", " 5", "0x5", "1.0", "10000000000000", "0.1234567890123"}) {
    EXPECT_FALSE(is_canonical_number(text)) << text;
  }
}

TEST(Digits, AreNoneInANumber) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double number : {0.0, -0.0, 1.0, -1e308, kInfinity, -kInfinity, kNaN, -kNaN}) {
    EXPECT_FALSE(is_digits(number)) << number;
  }
  volatile double infinity = kInfinity;
  EXPECT_FALSE(is_digits(infinity - infinity));
  EXPECT_EQ(plain(kNaN), 0);
}

}  // namespace
}  // namespace mirada::vm
