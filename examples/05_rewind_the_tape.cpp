// SPDX-License-Identifier: MIT
// Rewinding the tape: twenty continuations each from several moments of one run, which differ only in their seed. A difference
// between moments that exceeds the one among continuations was determined by then; the rest was still open.
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <string>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/rules/paper.hpp>
#include <vector>

using Ecology = trophic::Ecology<trophic::rules::Paper>;

constexpr double later_s = 300.0;

/// The share of robots with the tag +1, `later_s` after the moment on the tape.
double share_later(const std::string& tape, std::uint64_t seed) {
  Ecology ecology({.seed = seed}, trophic::backend::Kinematic::Params{});
  trophic::Archive archive{tape};
  ecology.persist(archive);
  ecology.run_until(ecology.time_s() + later_s);
  double plus = 0.0;
  for (const trophic::Individual& robot : ecology.view().robots) plus += robot.tag == 1 ? 1.0 : 0.0;
  return plus / static_cast<double>(ecology.view().robots.size());
}

int main() {
  constexpr std::size_t moments = 6;
  constexpr std::size_t continuations = 20;
  Ecology ecology({.seed = 42}, trophic::backend::Kinematic::Params{});
  std::vector<double> means;
  double within = 0.0;
  std::cout << std::fixed << std::setprecision(4) << "moment  mean    variance of " << continuations << " continuations\n";
  for (std::size_t moment = 1; moment <= moments; ++moment) {
    ecology.run_until(500.0 * static_cast<double>(moment));
    trophic::Archive tape;
    ecology.persist(tape);
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint64_t seed = 1; seed <= continuations; ++seed) {
      const double share = share_later(tape.bytes(), seed);
      sum += share;
      squares += share * share;
    }
    const double mean = sum / continuations;
    const double variance = (squares - continuations * mean * mean) / (continuations - 1);
    std::cout << std::setw(4) << static_cast<int>(ecology.time_s()) << " s  " << mean << "  " << variance << "\n";
    means.push_back(mean);
    within += variance / moments;
  }
  double mean = 0.0;
  for (const double one : means) mean += one / moments;
  double between = -within / continuations;  // variance of the means themselves, without the contribution of chance
  for (const double one : means) between += (one - mean) * (one - mean) / (moments - 1);
  std::cout << "variance within moments " << within << ", between moments " << between << "\n";
}
