// SPDX-License-Identifier: MIT
// libFuzzer's entry to one reader, which TROPHIC_FUZZED names: see scripts/fuzz.
#include <cstdint>
#include <fuzz/readers.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  for (const trophic::test::Reader& reader : trophic::test::readers) {
    if (reader.name == TROPHIC_FUZZED) trophic::test::try_reader(reader, {reinterpret_cast<const char*>(bytes), size});
  }
  return 0;
}
