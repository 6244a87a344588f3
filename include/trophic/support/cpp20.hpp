// SPDX-License-Identifier: MIT
// Rejects older C++ standards and compiler flags that change or crash a run, with one error: a missing file ends a compilation,
// #error does not.
#pragma once

#if __cplusplus < 202002L
#include <trophic needs C++20: compile with -std=c++20>
#endif
#if __FINITE_MATH_ONLY__ || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#include <trophic cannot be compiled with -ffast-math or -Ofast, which give a run other numbers>
#endif
#ifndef __cpp_exceptions
#include <trophic needs exceptions: compile without -fno-exceptions>
#endif
#if defined(_GLIBCXX_DEBUG) && defined(TROPHIC_HEADER_ONLY) && !TROPHIC_HEADER_ONLY
#include <trophic has compiled libraries without _GLIBCXX_DEBUG, whose containers differ: link trophic::trophic, the headers>
#endif
