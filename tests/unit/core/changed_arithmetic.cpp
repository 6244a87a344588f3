// SPDX-License-Identifier: MIT
// The arithmetic of this file, which is compiled with several sets of flags.
#include <trophic/support/arithmetic.hpp>

namespace trophic::test {

struct TROPHIC_TEST_NAME;
std::string_view TROPHIC_TEST_NAME() {
  return detail::changed_arithmetic<struct TROPHIC_TEST_NAME>();
}

}  // namespace trophic::test
