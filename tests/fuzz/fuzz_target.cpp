// SPDX-License-Identifier: MIT
// libFuzzer's entry to the reader that the environment variable TROPHIC_FUZZED names: see scripts/fuzz.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fuzz/readers.hpp>

namespace {

const trophic::test::Reader* fuzzed = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* name = std::getenv("TROPHIC_FUZZED");
  for (const trophic::test::Reader& reader : trophic::test::readers) {
    if (name != nullptr && reader.name == name) fuzzed = &reader;
  }
  if (fuzzed != nullptr) return 0;
  std::fputs("TROPHIC_FUZZED: must name a reader of tests/fuzz/readers.hpp\n", stderr);
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  trophic::test::try_reader(*fuzzed, {reinterpret_cast<const char*>(bytes), size});
  return 0;
}
