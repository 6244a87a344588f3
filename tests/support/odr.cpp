// SPDX-License-Identifier: MIT
// Second translation unit of every test program: two definitions of anything that is not inline do not link.
#include <trophic/trophic.hpp>
