// SPDX-License-Identifier: MIT
// Whether what is no template comes with the headers or from a library that was compiled once.
#pragma once

/// Functions that are no templates are declared in X.hpp and defined in X.ipp. Header-only, which is the default, X.hpp includes
/// X.ipp and they are inline. The targets trophic::compiled, trophic::mujoco_compiled and trophic::ode_compiled hold them
/// compiled and define TROPHIC_HEADER_ONLY as 0, so that a program includes no definition and none of the parsers, solvers and
/// engines that only definitions need. All parts of a program must agree.
#ifndef TROPHIC_HEADER_ONLY
#define TROPHIC_HEADER_ONLY 1
#endif

#if TROPHIC_HEADER_ONLY
#define TROPHIC_INLINE inline
#else
#define TROPHIC_INLINE
#endif
