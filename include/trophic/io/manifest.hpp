// SPDX-License-Identifier: MIT
// manifest.json: the origin of a run, and how it ended.
#pragma once

#include <trophic/io/csv_file.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/observe/tally.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

/// Facts that only the program knows: command line, host, and revision of its own source. trophic's programs provide them
/// (tools/command/provenance.hpp); your own program may provide its own.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// The compiler that built trophic (or the compiled library, if a program links it), with its version: "g++ 12.2.0".
[[nodiscard]] std::string compiler();

/// Writes the manifest when the run starts (status "running") and again when it ends: "complete", "stopped" (an observer ended it
/// early) or "failed" with the error. Each time the file is replaced as a whole.
class Manifest {
 public:
  Manifest(std::filesystem::path path, Provenance provenance);
  Manifest(Manifest&&) noexcept = default;
  Manifest& operator=(Manifest&&) noexcept = default;

  /// Takes part in checkpoints. After reading one, the manifest keeps the entries of the program that started the run; those of
  /// this program are added under "continued", with "other_build": "accepted" if its code differs.
  void persist(Archive& archive);

  /// Records that the run starts from another one, as read from its checkpoint; `origin`: that run ("run") and the moment
  /// ("at_s"), with its "seed" and "fingerprint".
  void begin_from(Provenance origin) {
    if (!continued_.empty()) provenance_ = continued_.back().provenance;
    continued_.clear();
    origin_ = std::move(origin);
  }

  void on_start(const observe::RunDescription& run, const View& view);
  void on_event(const observe::Event& event, const View& view) { tally_.on_event(event, view); }
  void on_change(const observe::RunDescription& run, const View&);
  void on_tick(const View& view) {
    reached_s_ = view.time_s;
    refused_bodies_ = view.refused_bodies;
    refused_births_ = view.refused_births;
  }
  void on_end(const View& view) {
    end_text_ = observe::end_text(view);
    finish(view.time_s < until_s_ && !view.is_over ? "stopped" : "complete");
  }
  void on_failure(std::string_view what);

  /// Sets the interval of agents.csv if it does not have all ticks; call this before `on_start`.
  void set_agents_every_ticks(std::int64_t every) { agents_every_ticks_ = every; }

  /// Sets the names of the inputs in senses.csv, for a run with that table; call this before `on_start`.
  void set_inputs(const std::vector<std::string>& inputs) { inputs_ = inputs; }

  /// Sets the sums of the run's tables, for the next write.
  void set_tables(const std::vector<std::pair<std::string, TableSum>>& tables);

  /// Sets the description of the run's recording, for the next write.
  void set_recording(std::uint64_t frames, std::uint32_t crc32);

  /// Adds provenance that is known only now, such as the wall time, and writes the manifest again.
  void add(const Provenance& provenance);

 private:
  struct Content;

  /// A program that resumed the run.
  struct Continuation {
    double from_s = 0.0;
    Provenance provenance;
    static constexpr auto saved() { return std::tuple{&Continuation::from_s, &Continuation::provenance}; }
  };

  void finish(std::string_view status);

  Provenance provenance_;
  std::vector<Continuation> continued_;
  Provenance origin_;
  std::shared_ptr<Content> content_;  ///< this object alone owns it
  observe::Tally tally_;
  std::int64_t agents_every_ticks_ = 1;
  std::optional<std::vector<std::string>> inputs_;
  std::optional<observe::RunDescription> changed_;  ///< the description after changes of parameters
  std::size_t described_ = 0;                       ///< changes in the file
  double until_s_ = 0.0;
  double reached_s_ = 0.0;
  std::string end_text_ = {};  ///< for a run that ends early
  bool inherits_bodies_ = false;
  std::uint64_t refused_bodies_ = 0;  ///< refused mutations, up to the last tick
  std::uint64_t refused_births_ = 0;  ///< births without a free body or space, up to the last tick
};

}  // namespace trophic::io

#if TROPHIC_HEADER_ONLY
#include <trophic/io/manifest.ipp>
#endif
