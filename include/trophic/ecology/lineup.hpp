// SPDX-License-Identifier: MIT
// Individuals in a contest, which is an ecology without births and deaths.
#pragma once

#include <trophic/ecology/simulation.hpp>

namespace trophic {

/// An individual of a contest.
struct Contestant {
  Species species = 0;
  Genome genome;  ///< its id has no meaning
};

/// One individual for each body.
using Lineup = std::vector<Contestant>;

/// Makes an experiment's ecology with given individuals at positions drawn from a seed.
using MakeContest = std::function<std::unique_ptr<Simulation>(std::uint64_t places, Lineup lineup)>;

}  // namespace trophic
