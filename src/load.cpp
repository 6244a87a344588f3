// SPDX-License-Identifier: MIT
// trophic::compiled: the file readers.
#include <trophic/load/arena.ipp>
#include <trophic/load/gait.ipp>
#include <trophic/load/habitat.ipp>
#include <trophic/load/models.ipp>
#include <trophic/load/robot.ipp>
#include <trophic/params/parse_toml.ipp>
