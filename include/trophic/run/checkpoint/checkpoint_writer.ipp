// SPDX-License-Identifier: MIT
// Definitions of checkpoint_writer.hpp.
#pragma once

#include <trophic/io/program_code.hpp>
#include <trophic/run/checkpoint/checkpoint_writer.hpp>
#include <trophic/support/version.hpp>

namespace trophic::checkpoint {

namespace detail {

inline void same(const std::string& what, const std::string& there, const std::string& ours) {
  if (there == ours) return;
  throw std::invalid_argument{"the checkpoint's " + what + " = " + there + ": must be " + ours + ", as in the run to resume"};
}

inline void read_section(const Checkpoint& from, const Part& part) {
  const std::string& bytes = from.section(part.section);
  try {
    Archive archive{bytes};
    part.persist(archive);
    archive.finish();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument{"section \"" + std::string{part.section} + "\" of the checkpoint: " + error.what()};
  }
}

[[nodiscard]] inline Part part_of(Simulation& ecology) {
  return {ecology_section, [&ecology](Archive& archive) { ecology.persist(archive); }};
}

}  // namespace detail

TROPHIC_INLINE void write(const std::filesystem::path& folder, Simulation& ecology, const observe::RunDescription& run,
                          const Parts& parts) {
  Parts all{detail::part_of(ecology)};
  all.insert(all.end(), parts.begin(), parts.end());
  write(folder,
        {.fingerprint = run.fingerprint,
         .program_version = std::string{version},
         .code = program_code(),
         .seed = run.seed,
         .tick = ecology.tick(),
         .time_s = ecology.time_s(),
         .sections = {}},
        all);
}

TROPHIC_INLINE void check_same_run(const Checkpoint& checkpoint, const observe::RunDescription& run) {
  detail::same("version of trophic", checkpoint.program_version, std::string{version});
  if (checkpoint.fingerprint != run.fingerprint) {
    throw std::invalid_argument{"the checkpoint's fingerprint = " + checkpoint.fingerprint + ": must be " + run.fingerprint +
                                ", as in the run to resume; its rules, parameters, models or engine differ"};
  }
  if (checkpoint.code != program_code()) {
    throw std::invalid_argument{"the checkpoint's code = " + checkpoint.code + ": must be " + program_code() +
                                ", as of this program; another build wrote it, whose rules may be others (--accept-other-build "
                                "resumes it, and the manifest says so)"};
  }
  detail::same("seed", std::to_string(checkpoint.seed), std::to_string(run.seed));
}

TROPHIC_INLINE void restore_any(const Checkpoint& checkpoint, Simulation& ecology, const Parts& parts) {
  const std::size_t sections = 1 + parts.size();
  if (checkpoint.sections.size() > sections) {
    throw std::invalid_argument{"the checkpoint has " + std::to_string(checkpoint.sections.size()) + " sections, the last of \"" +
                                checkpoint.sections.back().name + "\": must be " + std::to_string(sections) +
                                "; the run was made with more than this command"};
  }
  detail::read_section(checkpoint, detail::part_of(ecology));
  for (const Part& part : parts) detail::read_section(checkpoint, part);
}

TROPHIC_INLINE void restore(const Checkpoint& checkpoint, Simulation& ecology, const Parts& parts) {
  check_same_run(checkpoint, ecology.describe(0.0));
  restore_any(checkpoint, ecology, parts);
}

}  // namespace trophic::checkpoint
