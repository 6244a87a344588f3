// SPDX-License-Identifier: MIT
// When checkpoints are written, and who may resume from them.
#pragma once

#include <trophic/support/cpp20.hpp>

namespace trophic::checkpoint {

/// Whether a run may be resumed by a program other than the one that made it (trophic/io/program_code.hpp). Its rules may have
/// the same names but other code; the manifest lists the programs under "continued".
enum class OtherBuild { refused, accepted };

struct Schedule {
  double every_s =
      300.0;  ///< seconds of the ecology's clock between two checkpoints; 0: only when the run ends or is interrupted
  double most_share = 0.01;  ///< largest share of the wall time for checkpoints: a due one waits until it costs no more
  OtherBuild other_build = OtherBuild::refused;
  bool verifies = true;  ///< whether a complete run is kept only if its files have their checksums
};

}  // namespace trophic::checkpoint
