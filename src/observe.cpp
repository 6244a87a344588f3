// SPDX-License-Identifier: MIT
// trophic::compiled: what runs leave behind.
#include <trophic/checkpoint/checkpoint_file.ipp>
#include <trophic/checkpoint/go_on.ipp>
#include <trophic/checkpoint/keeper.ipp>
#include <trophic/checkpoint/rewind.ipp>
#include <trophic/observe/growing_file.ipp>
#include <trophic/observe/manifest.ipp>
#include <trophic/observe/progress.ipp>
#include <trophic/observe/read_recording.ipp>
#include <trophic/observe/recording.ipp>
#include <trophic/observe/recording_planes.ipp>
#include <trophic/observe/run_description.ipp>
#include <trophic/observe/run_folder.ipp>
#include <trophic/observe/terminal.ipp>
#include <trophic/replicates/run.ipp>
#include <trophic/replicates/run_with_shadow.ipp>
#include <trophic/replicates/sweep/attempt.ipp>
#include <trophic/replicates/sweep/claim.ipp>
#include <trophic/replicates/sweep/folder.ipp>
#include <trophic/replicates/sweep/plan_file.ipp>
#include <trophic/replicates/sweep/sweep_file.ipp>
#include <trophic/replicates/sweep/work_through.ipp>
#include <trophic/support/checksum.ipp>
#include <trophic/support/json.ipp>
#include <trophic/support/new_file.ipp>
#include <trophic/support/replace_file.ipp>
#include <trophic/support/whole_file.ipp>
