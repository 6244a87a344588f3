// SPDX-License-Identifier: MIT
// When checkpoints are written, and who may resume from them.
#pragma once

#include <trophic/support/cpp20.hpp>

namespace trophic::checkpoint {

/// Whether a run may be resumed by a program other than the one that made it (trophic/io/program_code.hpp). Its rules may be
/// other rules under the same names; the manifest lists the programs under "continued".
enum class OtherBuild { refused, accepted };

struct Schedule {
  double every_s = 300.0;    ///< seconds of the ecology's clock between two; 0: only where the run ends or is stopped
  double most_share = 0.01;  ///< of the wall time that may go into them: one that is due waits until it costs no more
  OtherBuild other_build = OtherBuild::refused;
  bool verifies = true;  ///< whether a complete run is kept only if its files have their checksums
};

}  // namespace trophic::checkpoint
