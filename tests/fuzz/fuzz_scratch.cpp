// The reader of Scratch projects: as bare JSON, and (first byte P) as an archive.
#include "fuzz/run_some.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  mirada::vm::fuzz::run_some(bytes);
  // What is no archive and has lost its "targets" would go to the other reader, which has a fuzzer of its
  // own.
  if (!bytes.starts_with("PK")) mirada::vm::fuzz::run_some(R"({"targets":[)" + std::string(bytes) + "]}");
  return 0;
}
