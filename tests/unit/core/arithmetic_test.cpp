// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/support/arithmetic.hpp>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace trophic::test {

/// What differs in changed_arithmetic.cpp under the flags of tests/unit/core/CMakeLists.txt.
std::string_view arithmetic_fused();
std::string_view arithmetic_reordered();
std::string_view arithmetic_reciprocal();
std::string_view arithmetic_without_signs();
std::string_view arithmetic_single();

}  // namespace trophic::test

using namespace trophic;

TEST_CASE("arithmetic: code of these tests -> plain double precision") {
  CHECK(detail::changed_arithmetic<int>() == "");
  CHECK_NOTHROW(check_arithmetic<int>());
}

#ifdef TROPHIC_TEST_FLAGS
TEST_CASE("arithmetic: code that was compiled with a flag without a macro -> found") {
  CHECK(test::arithmetic_reordered().starts_with("reorders sums"));
  CHECK(test::arithmetic_reciprocal().starts_with("multiplies by reciprocals"));
  CHECK(test::arithmetic_without_signs().starts_with("ignores the sign of zero"));
  CHECK(test::arithmetic_single().starts_with("has constants of single precision"));
  if (__builtin_cpu_supports("fma")) CHECK(test::arithmetic_fused().starts_with("fuses multiplications"));
}

TEST_CASE("arithmetic: processor that treats subnormal numbers as zero -> refused by a sentence with what to do") {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040U);
  CHECK_THROWS_WITH_AS(check_arithmetic<int>(),
                       "this program was compiled so that it treats subnormal numbers as zero, which changes the numbers of a "
                       "run: must be compiled with -fno-fast-math, and linked with it",
                       std::runtime_error);
  _mm_setcsr(before);
}
#endif
