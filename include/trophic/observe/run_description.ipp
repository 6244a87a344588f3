// SPDX-License-Identifier: MIT
// Definitions of run_description.hpp.
#pragma once

#include <algorithm>
#include <cstdio>
#include <trophic/observe/run_description.hpp>

namespace trophic::observe {

namespace detail {

/// A path without "rules.".
[[nodiscard]] inline std::string short_path(const std::string& path) {
  return path.starts_with("rules.") ? path.substr(6) : path;
}

[[nodiscard]] inline std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (const std::string& part : parts) text.append(text.empty() ? "" : between).append(part);
  return text;
}

/// As trophic::checksum, without zlib: a program that writes no files does not link it.
[[nodiscard]] inline std::uint32_t crc32_of(std::string_view text) {
  std::uint32_t crc = ~0U;
  for (const char byte : text) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

}  // namespace detail

TROPHIC_INLINE bool makes_another_experiment(std::string_view path) {
  return path != "seed" && path != "ecology.duration_s" && path != "ecology.ends_when" && path != "backend.threads";
}

TROPHIC_INLINE std::string fingerprint(const RunDescription& run, std::string_view models) {
  std::string text = run.backend + "\n";
  for (const auto& [slot, policy] : run.slots) text += slot + "=" + policy + "\n";
  for (const NamedParam& param : run.named_params)
    if (makes_another_experiment(param.path)) text += param.path + "=" + value_text(param) + "\n";
  return hash_text(text.append(models));
}

TROPHIC_INLINE std::vector<OtherParam> other_params(const NamedParams& own, const NamedParams& table) {
  std::vector<OtherParam> others;
  for (const NamedParam& param : own) {
    const auto its = std::ranges::find(table, param.path, &NamedParam::path);
    if (its == table.end() || its->value == param.value || !makes_another_experiment(param.path)) continue;
    const std::string text = value_text(*its);
    if (text.empty()) continue;  // follows from another parameter, as the gait from the robot
    others.push_back({.path = param.path, .value = value_text(param), .table = text});
  }
  return others;
}

TROPHIC_INLINE std::vector<ParameterChange> effective(std::vector<ParameterChange> changes) {
  std::ranges::stable_sort(changes, {}, [](const ParameterChange& change) { return std::tie(change.tick, change.number); });
  std::vector<ParameterChange> kept;
  for (ParameterChange& change : changes) {
    if (!kept.empty() && kept.back().tick == change.tick && kept.back().number == change.number) {
      kept.back().value = std::move(change.value);
    } else {
      kept.push_back(std::move(change));
    }
  }
  std::erase_if(kept, [](const ParameterChange& change) { return change.value == change.before; });
  return kept;
}

TROPHIC_INLINE std::string identity(const RunDescription& run) {
  std::string text;
  if (run.branch) text = run.branch->at_s + " " + run.branch->seed + " " + run.branch->fingerprint + "\n";
  for (const ParameterChange& change : effective(run.changes)) {
    text += std::to_string(change.tick) + " " + change.number + "=" + change.value + "\n";
  }
  if (text.empty()) return run.fingerprint;
  std::array<char, 16> digits{};
  std::snprintf(digits.data(), digits.size(), "+%08x", static_cast<unsigned>(detail::crc32_of(text)));
  return run.fingerprint + digits.data();
}

TROPHIC_INLINE std::string short_name(const RunDescription& run) {
  std::vector<std::string> parts;
  const std::vector<OtherParam>& others = run.other_params;
  if (others.size() == 1) parts.push_back(detail::short_path(others[0].path) + " " + others[0].value);
  if (others.size() > 1) parts.push_back(std::to_string(others.size()) + " parameters");
  const std::vector<ParameterChange> changes = effective(run.changes);
  if (changes.size() == 1) {
    parts.push_back(detail::short_path(changes[0].number) + " " + changes[0].value + " at " + number_text(changes[0].time_s) +
                    " s");
  } else if (!changes.empty()) {
    parts.push_back(std::to_string(changes.size()) + " changes");
  }
  if (run.branch) parts.push_back("from " + run.branch->at_s + " s");
  return run.rules + (parts.empty() ? "" : " (" + detail::joined(parts, "; ") + ")");
}

TROPHIC_INLINE std::string sentence(const RunDescription& run) {
  std::vector<std::string> parts;
  for (const OtherParam& param : run.other_params) {
    parts.push_back(param.path + " = " + param.value + " (the table's: " + param.table + ")");
  }
  std::string text = "rule table `" + run.rules + "` and " + (parts.empty() ? "its parameters" : detail::joined(parts, ", "));
  for (const ParameterChange& change : effective(run.changes)) {
    text +=
        "; at " + number_text(change.time_s) + " s " + change.number + " changes from " + change.before + " to " + change.value;
  }
  if (run.branch) text += "; begins at " + run.branch->at_s + " s of " + run.branch->run + " (seed " + run.branch->seed + ")";
  return text;
}

}  // namespace trophic::observe
