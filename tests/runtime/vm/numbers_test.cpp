#include "vm/numbers.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "vm/catalog.h"

namespace mirada::vm {
namespace {

TEST(Numbers, ArePrintedAsJavaScriptPrintsThem) {
  EXPECT_EQ(number_to_string(1e21), "1e+21");
  EXPECT_EQ(number_to_string(123456789012345680000.0), "123456789012345680000");
  EXPECT_EQ(number_to_string(1e-7), "1e-7");
  EXPECT_EQ(number_to_string(-0.0), "0");
  EXPECT_EQ(number_to_string(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(number_to_string(std::numeric_limits<double>::infinity()), "Infinity");
}

TEST(Numbers, AreReadAsJavaScriptReadsThem) {
  EXPECT_EQ(string_to_number("0x1F"), 31);
  EXPECT_EQ(string_to_number(" 5. "), 5);
  EXPECT_EQ(string_to_number(""), 0);
  EXPECT_TRUE(std::isnan(string_to_number("1,000")));
  EXPECT_TRUE(std::isnan(string_to_number("infinity")));
}

TEST(Numbers, ModuloHasTheDivisorsSign) {
  EXPECT_EQ(modulo(-7, 3), 2);
  EXPECT_EQ(modulo(7, -3), -2);
  EXPECT_DOUBLE_EQ(modulo(5.5, 2), 1.5);
  EXPECT_TRUE(std::isnan(modulo(1, 0)));
}

TEST(Numbers, HalvesAreRoundedUp) {
  EXPECT_EQ(round_half_up(-2.5), -2);
  EXPECT_EQ(round_half_up(2.5), 3);
  EXPECT_EQ(round_half_up(0.49999999999999994), 0);
}

/// Recorded from V8.
TEST(Numbers, PowersOfTenAreV8sToTheLastBit) {
  EXPECT_EQ(apply_math(MathFn::pow10, 2.5), 316.2277660168379);
  EXPECT_EQ(apply_math(MathFn::pow10, 0.1), 1.2589254117941673);
  EXPECT_EQ(apply_math(MathFn::pow10, -4), 0.00009999999999999999);
  EXPECT_EQ(apply_math(MathFn::pow10, -28.1), 7.943282347242789e-29);
  EXPECT_EQ(apply_math(MathFn::pow10, 308), 1e308);
  EXPECT_EQ(apply_math(MathFn::pow10, 0), 1);
  EXPECT_EQ(apply_math(MathFn::pow10, -1), 0.1);
  EXPECT_EQ(apply_math(MathFn::pow10, 309), std::numeric_limits<double>::infinity());
  EXPECT_EQ(apply_math(MathFn::pow10, -324), 0);
}

/// Recorded from V8.
TEST(Numbers, ArcsAreV8sToTheLastBit) {
  EXPECT_EQ(apply_math(MathFn::asin, -0.5635159374214709), -34.29929869752513);
  EXPECT_EQ(apply_math(MathFn::asin, 0.98), 78.52165904546642);
  EXPECT_EQ(apply_math(MathFn::acos, -0.48513307655230165), 119.0211915892418);
  EXPECT_EQ(apply_math(MathFn::acos, 0.46326456032693386), 62.402034923009424);
  EXPECT_EQ(apply_math(MathFn::acos, -0.06344384513795376), 93.63750758621754);
  EXPECT_EQ(apply_math(MathFn::atan, 7.134407726116478), 82.02107252715398);
  EXPECT_EQ(apply_math(MathFn::atan, -0.6853324119001627), -34.424104535111866);
  EXPECT_EQ(apply_math(MathFn::atan, 228), 89.74870433279106);
  EXPECT_EQ(apply_math(MathFn::atan, -std::numeric_limits<double>::infinity()), -90);
  EXPECT_TRUE(std::isnan(apply_math(MathFn::asin, 1.5)));
}

TEST(BlockCatalog, RefusesAnOpcodeTwice) {
  BlockCatalog catalog;
  BlockDef def;
  def.opcode = "dance_spin";
  EXPECT_TRUE(catalog.add(def));
  EXPECT_FALSE(catalog.add(def));
  EXPECT_NE(catalog.find("dance_spin"), nullptr);
  EXPECT_EQ(catalog.find("dance_jump"), nullptr);
}

}  // namespace
}  // namespace mirada::vm
