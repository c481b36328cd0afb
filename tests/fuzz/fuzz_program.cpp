// The program reader: any bytes are a program or are refused in words.
#include "fuzz/run_some.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mirada::vm::fuzz::run_some({reinterpret_cast<const char*>(data), size});
  return 0;
}
