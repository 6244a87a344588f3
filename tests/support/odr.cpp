// SPDX-License-Identifier: MIT
// Every public header in a second translation unit of a program: two definitions of anything that is not inline do not link.
#include <trophic/trophic.hpp>
