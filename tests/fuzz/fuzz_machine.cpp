// Compiler and machine: a random valid program leaves what the plain reference evaluator says.
#include <cstdio>
#include <cstdlib>

#include "fuzz/reference/compare.h"
#include "programs/support.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mirada::vm;
  const std::string difference = reference::difference(data, size, test::core_catalog());
  if (difference.empty()) return 0;
  std::fprintf(stderr, "%s\n", difference.c_str());
  std::abort();
}
