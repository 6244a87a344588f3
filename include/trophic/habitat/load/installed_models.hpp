// SPDX-License-Identifier: MIT
// Where the models lie that came with the library.
#pragma once

/// The folder that the library was built or installed with; a default argument of every loader, because a library that was
/// compiled in one place may be installed in another. Its CMake targets define it. For builds without CMake `cmake --install`
/// writes it into a header, because no quotes survive `$(pkg-config --cflags trophic)`. Empty: there is none.
#ifndef TROPHIC_MODEL_DIR
#if __has_include(<trophic/habitat/load/installed_model_dir.hpp>)
#include <trophic/habitat/load/installed_model_dir.hpp>
#else
#define TROPHIC_MODEL_DIR ""
#endif
#endif
