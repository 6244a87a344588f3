// SPDX-License-Identifier: MIT
// The definitions of trophic/experiment/stepped_ecology.hpp.
#include <bit>
#include <stdexcept>
#include <tools/command/offers.hpp>
#include <tools/command/provenance.hpp>
#include <trophic/experiment/stepped_ecology.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/word_hash.hpp>
#include <utility>

namespace trophic {

namespace stepped {

/// Keeps events until the next decisions.
struct Events {
  std::vector<Happened> all = {};
  void on_event(const observe::Event& event, const View& view) {
    const bool is_birth = event.kind == observe::EventKind::birth;
    all.push_back({.tick = view.tick,
                   .time_s = view.time_s,
                   .kind = event.kind,
                   .id = event.individual.id,
                   .species = event.individual.species,
                   .other = is_birth ? event.individual.parent() : event.other,
                   .cause = event.cause});
  }
};

/// A hash of all decisions of a run, which are its input beside parameters and seed.
class Decided {
 public:
  static constexpr std::string_view section = "decisions";
  [[nodiscard]] static bool wants_decisions() { return true; }
  void on_decision(const observe::DecisionRecord& one, const View& view) {
    WordHash hash;
    hash.add(hash_);
    hash.add(static_cast<std::uint64_t>(view.tick));
    hash.add(view.robots[one.body].id);
    hash.add(std::bit_cast<std::uint64_t>(one.target_angle_rad));
    hash.add(static_cast<std::uint64_t>(one.tag));
    for (const double output : one.outputs) hash.add(std::bit_cast<std::uint64_t>(output));
    hash_ = hash.value();
  }
  void persist(Archive& archive) { archive(hash_); }
  /// 16 hexadecimal digits.
  [[nodiscard]] std::string text() const {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) text += digits[(hash_ >> static_cast<unsigned>(shift)) & 15U];
    return text;
  }

 private:
  std::uint64_t hash_ = 0;
};

/// The files of a run, with checkpoints.
struct Files {
  Files(Simulation& simulation, const std::filesystem::path& path, const checkpoint::RunState& state, Decided& decided)
      : folder{path,
               {{"host", host_name()}, {"trophic_revision", trophic_revision}, {"source_revision", command::source_revision()}},
               {},
               state.opening(),
               simulation.state_columns()},
        writer{path, {}, checkpoint::parts_of(folder, decided)} {
    // run_state_in has compared it with the description of a run that is decided from outside.
    if (state.from) checkpoint::restore_any(*state.from, simulation, checkpoint::parts_of(folder, decided));
  }
  io::RunFolder folder;
  checkpoint::CheckpointWriter writer;
};

}  // namespace stepped

struct SteppedEcology::Run {
  std::unique_ptr<Simulation> simulation;
  stepped::Events events = {};
  stepped::Decided decided = {};
  std::unique_ptr<stepped::Files> files = {};
  std::unique_ptr<SteppedRun> steps = {};
  bool is_noted = false;

  /// After the end of the run.
  void note_decisions() {
    if (files && !std::exchange(is_noted, true)) files->folder.manifest().add({{"decisions", decided.text()}});
  }
};

SteppedEcology::SteppedEcology(const Json& description, Offer offer)
    : offer_{std::move(offer)},
      described_{described_run(description, offer_)},
      until_s_{described_.experiment->ecology().duration_s} {}
SteppedEcology::~SteppedEcology() = default;

void SteppedEcology::reset(std::optional<std::uint64_t> seed, const std::filesystem::path& folder, bool resume) {
  close();
  if (seed) described_.experiment->seed() = *seed;
  auto run = std::make_unique<Run>(Run{.simulation = described_.simulation()});
  if (folder.empty()) {
    run->steps = std::make_unique<SteppedRun>(*run->simulation, until_s_, run->events);
  } else {
    checkpoint::RunState state;
    if (!resume) io::check_new_folder(folder);
    if (resume) state = checkpoint::run_state_in(folder, run->simulation->stepping().describe_outside(until_s_));
    if (state.complete) throw std::invalid_argument{folder.string() + ": " + state.remark};
    run->files = std::make_unique<stepped::Files>(*run->simulation, folder, state, run->decided);
    run->steps = std::make_unique<SteppedRun>(*run->simulation, until_s_, run->events, run->decided, run->files->folder,
                                              run->files->writer);
  }
  run_ = std::move(run);
}

void SteppedEcology::close() {
  if (run_ && !run_->simulation->stepping().is_in_tick()) {
    run_->steps->stop();
    run_->note_decisions();
  }
  run_.reset();
}

SteppedEcology::Run& SteppedEcology::run() const {
  if (!run_) throw std::logic_error{"the ecology has no run: call reset first"};
  return *run_;
}

bool SteppedEcology::sense() {
  Run& own = run();
  const bool goes_on = own.steps->sense();
  if (!goes_on) own.note_decisions();
  return goes_on;
}
void SteppedEcology::decide(std::span<const double> outputs) {
  Run& own = run();
  const auto before = std::ssize(own.events.all);
  own.steps->decide(outputs);
  own.events.all.erase(own.events.all.begin(), own.events.all.begin() + before);
}
void SteppedEcology::check(std::span<const double> outputs) const {
  run().steps->check(outputs);
}
bool SteppedEcology::run_until(double until_s) {
  while ((waits() || sense()) && (simulation().time_s() < until_s || until_s >= until_s_)) decide(own_outputs());
  return waits();
}
std::span<const double> SteppedEcology::own_outputs() {
  return run().steps->own_outputs();
}
const Perceived& SteppedEcology::perceived() const {
  return run().steps->perceived();
}
bool SteppedEcology::waits() const {
  return run().steps->waits();
}
const Simulation& SteppedEcology::simulation() const {
  return *run().simulation;
}
Spaces SteppedEcology::spaces() const {
  return run().simulation->stepping().spaces();
}
observe::RunDescription SteppedEcology::description() const {
  return run().simulation->stepping().describe_outside(until_s_);
}
const std::vector<Happened>& SteppedEcology::events() const {
  return run().events.all;
}

}  // namespace trophic
