// SPDX-License-Identifier: MIT
// The page of parts.hpp. Includes what `trophic show` compiles, so that its headers are read once.
#include "parts.hpp"

#include <tools/reading/csv_reader.cpp>
#include <tools/reading/run_folders.cpp>
#include <tools/reading/run_manifest.cpp>
#include <tools/recording/read_recording.cpp>
#include <tools/trophic/replay/base64.cpp>
#include <tools/trophic/replay/director.cpp>
#include <tools/trophic/replay/own_tables.cpp>
#include <tools/trophic/replay/page.cpp>
#include <tools/trophic/replay/recorded_run.cpp>
#include <tools/trophic/replay/shot.cpp>
#include <trophic/support/new_file.hpp>

namespace trophic::first_run {

void write_page(const std::filesystem::path& folder, const std::filesystem::path& page) {
  write_new_file(page, command::replay::page_of({command::replay::open_run(folder)}, {}));
}

}  // namespace trophic::first_run
