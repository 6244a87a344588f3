// SPDX-License-Identifier: MIT
// Definitions of recorded_run.hpp.
#include <tools/trophic/replay/recorded_run.hpp>

#include <algorithm>
#include <tools/command/check_folder.hpp>
#include <tools/trophic/replay/own_tables.hpp>
#include <trophic/params/params.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::command::replay {

Json read_manifest(const std::filesystem::path& folder, const io::RecordingHead& head) {
  const std::filesystem::path path = folder / "manifest.json";
  auto manifest = parse_sealed(read_whole_file(path));
  if (!manifest.is_object()) {
    throw std::invalid_argument{path.string() + ": is not a run's manifest, or was modified after trophic wrote it"};
  }
  try {
    const auto fingerprint = manifest.at("fingerprint").get<std::string>();
    const Json& seed = manifest.at("seed");
    if (fingerprint != head.fingerprint || seed != Json(head.seed)) {
      throw std::invalid_argument{path.string() + ": fingerprint " + fingerprint + ", seed " + json_text(seed) +
                                  ", but replay.trp next to it is of fingerprint " + head.fingerprint + ", seed " +
                                  std::to_string(head.seed) + "; they belong to different runs"};
    }
  } catch (const Json::exception& error) {
    throw std::invalid_argument{path.string() + ": " + reason_of(error)};
  }
  return manifest;
}

std::string runs_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator{folder, ignored}) {
    for (const char* file : {"manifest.json", "replicates.json"}) {
      if (std::filesystem::exists(entry.path() / file, ignored)) names.push_back(entry.path().string());
    }
  }
  std::ranges::sort(names);
  std::string text = folder.string() + ": is not a run";
  constexpr std::size_t shown = 10;
  for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) text += (i == 0 ? "; in it are " : ", ") + names[i];
  return text + (names.size() > shown ? " and " + std::to_string(names.size() - shown) + " more" : "");
}

RecordedRun open_run(const std::filesystem::path& folder) {
  check_folder(folder);
  if (!std::filesystem::exists(folder / "manifest.json") && !std::filesystem::exists(folder / "replay.trp"))
    throw std::invalid_argument{runs_in(folder)};
  const std::filesystem::path path = folder / "replay.trp";
  if (!std::filesystem::exists(path)) {
    throw std::invalid_argument{path.string() + ": does not exist; a run with --replay-hz 0 writes no recording"};
  }
  try {
    io::RecordingReader recording{path};
    auto manifest = read_manifest(folder, recording.head());
    if (manifest.value("agents_every_ticks", Json(1)) != Json(1)) {
      throw std::invalid_argument{(folder / "agents.csv").string() + ": has the ticks that are multiples of " +
                                  json_text(manifest["agents_every_ticks"]) +
                                  ": must have all ticks to be shown, as with --agents-every 1"};
    }
    if (const std::string damage = checkpoint::damage_in(folder); !damage.empty()) throw std::invalid_argument{damage};
    RecordedRun run{folder, std::move(manifest), std::move(recording), {}};
    if (!run.recording.remark().empty()) run.remarks.push_back(run.recording.remark());
    check_own_tables(folder, run.recording, run.manifest);
    return run;
  } catch (const Json::exception& error) {
    throw std::invalid_argument{(folder / "manifest.json").string() + ": " + reason_of(error)};
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
}

void Window::check(const io::RecordingReader& recording) const {
  if (from_s) static_cast<void>(recording.frame_at(*from_s));
  if (to_s) static_cast<void>(recording.frame_at(*to_s));
  if (from_s && to_s && !(*from_s <= *to_s)) {
    throw std::invalid_argument{"--from " + number_text(*from_s) + ": must be <= --to, " + number_text(*to_s)};
  }
}

double Window::start_s(const io::RecordingReader& recording) const {
  return from_s.value_or(recording.head().first_time_s);
}

double Window::end_s(const io::RecordingReader& recording) const {
  return to_s.value_or(recording.time_s(recording.frames() - 1));
}

bool Window::has_tick(double time_s, double tick_s) const {
  return !(from_s && time_s <= *from_s - tick_s + 1e-9) && !(to_s && time_s > *to_s + 1e-9);
}

}  // namespace trophic::command::replay
