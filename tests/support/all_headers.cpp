// SPDX-License-Identifier: MIT
// Every public header but the command line's, for a compiler that the tests are not built with.
#include <trophic/trophic.hpp>
