// SPDX-License-Identifier: MIT
// trophic::compiled: what runs leave behind.
#include <trophic/observe/manifest.ipp>
#include <trophic/observe/progress.ipp>
#include <trophic/observe/read_recording.ipp>
#include <trophic/observe/recording.ipp>
#include <trophic/observe/run_description.ipp>
#include <trophic/observe/run_folder.ipp>
#include <trophic/observe/terminal.ipp>
#include <trophic/support/replace_file.ipp>
