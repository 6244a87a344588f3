// SPDX-License-Identifier: MIT
// trophic::compiled: statistics.
#include <trophic/analysis/statistics/power.ipp>
#include <trophic/analysis/statistics/student_t.ipp>
