// SPDX-License-Identifier: MIT
// Refuses an older C++ by one error: a file that cannot be included ends a compilation, an #error does not.
#pragma once

#if __cplusplus < 202002L
#include <trophic needs C++20: compile with -std=c++20>
#endif
