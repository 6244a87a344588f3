// SPDX-License-Identifier: MIT
// The folder of the models that are installed with the library.
#pragma once

/// The folder that the library was built or installed with; a default argument of every loader, because a compiled library may
/// be installed in another place. Its CMake targets define it. For builds without CMake `cmake --install` writes it into a
/// header, because quotes do not survive `$(pkg-config --cflags trophic)`. Empty: none.
#ifndef TROPHIC_MODEL_DIR
#if __has_include(<trophic/habitat/load/installed_model_dir.hpp>)
#include <trophic/habitat/load/installed_model_dir.hpp>
#else
#define TROPHIC_MODEL_DIR ""
#endif
#endif
