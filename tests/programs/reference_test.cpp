// Random programs, run on the machine and by the plain evaluator that the fuzzer compares it with.
#include <gtest/gtest.h>

#include "base/random.h"
#include "fuzz/reference/compare.h"
#include "fuzz/reference/evaluate.h"
#include "programs/support.h"

namespace mirada::vm::test {
namespace {

std::vector<std::uint8_t> bytes(Random& random) {
  std::vector<std::uint8_t> out(static_cast<std::size_t>(random.integer(20, 400)));
  for (std::uint8_t& byte : out) byte = static_cast<std::uint8_t>(random.integer(0, 255));
  return out;
}

TEST(Reference, RandomProgramsLeaveWhatThePlainEvaluatorSays) {
  Random random{1, "programs"};
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const std::vector<std::uint8_t> data = bytes(random);
    compared += reference::evaluate(reference::grow(data.data(), data.size())).has_value();
    ASSERT_EQ(reference::difference(data.data(), data.size(), core_catalog()), "") << "program " << i;
  }
  EXPECT_GT(compared, 200);
}

}  // namespace
}  // namespace mirada::vm::test
