// SPDX-License-Identifier: MIT
// Definitions of changing_simulation.hpp.
#include <exception>
#include <tools/changes/changing_simulation.hpp>
#include <tools/changes/may_follow.hpp>
#include <trophic/io/csv_file.hpp>
#include <trophic/params/named_params.hpp>

namespace trophic::changes {

namespace detail {
/// The value of a number as text.
[[nodiscard]] inline std::string value_in(const observe::RunDescription& run, const std::string& number) {
  const auto found = std::ranges::find(run.named_params, number, &NamedParam::path);
  if (found == run.named_params.end()) throw std::invalid_argument{number + ": is not a parameter of this experiment"};
  return value_text(*found);
}

/// changes.csv of one run.
class ChangeTable {
 public:
  ChangeTable(const std::filesystem::path& folder, Opening opening) : file_{folder / file_name, opening} {}
  void write(const observe::ParameterChange& change) {
    file_.write({change.time_s, change.tick, change.number, change.value, change.before});
    file_.flush();
  }
  void on_end(const View&) { file_.finish(); }
  void persist(Archive& archive) { archive(file_); }
  [[nodiscard]] io::TableSum sum() const { return file_.sum(); }

 private:
  io::CsvFile<ChangeRow> file_;
};

}  // namespace detail

/// The table that takes the rows of changes, while there is one.
struct ChangingSimulation::Journal {
  detail::ChangeTable* table = nullptr;
};

/// The observers of the whole run, as those of each of its parts.
class ChangingSimulation::Relay final : public observe::Audience {
 public:
  Relay(ChangingSimulation& whole, observe::Audience& audience, double until_s)
      : whole_{whole}, audience_{audience}, until_s_{until_s} {}

  /// The changes that ended the last part of the run, and whether they are wishes.
  [[nodiscard]] std::pair<std::vector<Change>, bool> take() { return {std::exchange(due_, {}), are_wishes_}; }
  [[nodiscard]] bool has_failed() const { return has_failed_; }

  void start(const observe::RunDescription&, const View& view) override {
    if (!std::exchange(is_started_, true)) audience_.start(whole_.describe(until_s_), view);
  }
  void event(const observe::Event& event, const View& view) override { audience_.event(event, view); }
  void change(const observe::RunDescription& run, const View& view) override { audience_.change(run, view); }
  void tick(const View& view) override { audience_.tick(view); }
  void between_ticks(Simulation&, bool last) override {
    if (!last) audience_.between_ticks(whole_, false);
  }
  void end(const View&) override {}
  void failure(std::string_view what) override {
    has_failed_ = true;
    audience_.failure(what);
  }
  [[nodiscard]] bool keep_running() override {
    if (!audience_.keep_running()) return false;
    due_ = whole_.scheduled_until(whole_.time_s());
    are_wishes_ = due_.empty();
    if (!due_.empty() || whole_.conductor_ == nullptr) return due_.empty();
    due_ = whole_.conductor_->due(whole_.time_s());
    return due_.empty() && !whole_.conductor_->ends();
  }
  [[nodiscard]] bool may_cancel() const override { return audience_.may_cancel(); }
  [[nodiscard]] bool cancels_tick() override { return audience_.cancels_tick(); }
  [[nodiscard]] bool wants_decisions() override { return audience_.wants_decisions(); }
  void decision(const observe::DecisionRecord& decision, const View& view) override { audience_.decision(decision, view); }
  void exemption(BodyIndex hunter, const View& view) override { audience_.exemption(hunter, view); }
  [[nodiscard]] std::int64_t next_frame(const observe::FrameTimes& times, std::int64_t step) override {
    return audience_.next_frame(times, step);
  }
  [[nodiscard]] bool wants_frame(const observe::FrameTimes& times, std::int64_t step) override {
    return audience_.wants_frame(times, step);
  }
  void frame(const observe::Frame& frame, std::int64_t step) override { audience_.frame(frame, step); }

 private:
  ChangingSimulation& whole_;
  observe::Audience& audience_;
  double until_s_;
  std::vector<Change> due_;
  bool are_wishes_ = false;
  bool is_started_ = false;
  bool has_failed_ = false;
};

ChangingSimulation::ChangingSimulation(MakeChanged make, std::vector<Change> schedule, Conductor* conductor)
    : make_{std::move(make)},
      conductor_{conductor},
      schedule_{std::move(schedule)},
      journal_{std::make_shared<Journal>()},
      current_{make_({})},
      first_{current_->describe(0.0)} {
  // Each state of the parameters, so that nothing is refused halfway.
  Values values;
  for (std::span<const Change> left{schedule_}; !left.empty();) {
    const auto later = std::ranges::find_if(left, [&](const Change& change) { return change.time_s != left.front().time_s; });
    const auto together = left.first(made_together({left.begin(), later}));
    static_cast<void>(changed(values, together));
    for (const Change& change : together) values[change.number] = change.value;
    left = left.subspan(together.size());
  }
}
ChangingSimulation::~ChangingSimulation() = default;

observe::RunDescription ChangingSimulation::describe(double until_s) const {
  observe::RunDescription run = first_;
  run.until_s = until_s;
  run.changes = made_;
  return run;
}

io::StateColumns ChangingSimulation::state_columns() const {
  io::StateColumns columns = current_->state_columns();
  columns.append = [this, of = static_cast<const Simulation*>(nullptr), now = io::StateColumns{}](BodyIndex body,
                                                                                                  std::string& row) mutable {
    if (of != current_.get()) now = (of = current_.get())->state_columns();
    now.append(body, row);
  };
  return columns;
}

io::MakeOwnTable ChangingSimulation::table() const {
  class Table final : public io::AnyOwnTable {
   public:
    Table(std::shared_ptr<Journal> journal, const std::filesystem::path& folder, Opening opening)
        : journal_{std::move(journal)}, table_{folder, opening}, observer_{table_} {
      journal_->table = &table_;
    }
    ~Table() override { journal_->table = nullptr; }
    [[nodiscard]] std::string file_name() const override { return std::string{changes::file_name}; }
    [[nodiscard]] observe::Audience& observer() override { return observer_; }
    [[nodiscard]] io::TableSum sum() const override { return table_.sum(); }
    void persist(Archive& archive) override { archive(table_); }

   private:
    std::shared_ptr<Journal> journal_;
    detail::ChangeTable table_;
    observe::AudienceOf<detail::ChangeTable> observer_;
  };
  return [journal = journal_](const std::filesystem::path& folder, Opening opening) -> std::unique_ptr<io::AnyOwnTable> {
    return std::make_unique<Table>(journal, folder, opening);
  };
}

void ChangingSimulation::persist(Archive& archive) {
  std::vector<observe::ParameterChange> made = made_;
  std::vector<Change> schedule = schedule_;
  archive(made, schedule);
  if (archive.reads()) {
    values_.clear();
    for (const observe::ParameterChange& row : made) values_[row.number] = row.value;
    current_ = changed(values_, {});
    Archive::require(schedule_.empty() || are_scheduled(made, schedule),
                     "changes other than those of --changes; without --changes the run resumes with its own");
    made_ = std::move(made);
    schedule_ = std::move(schedule);
  }
  current_->persist(archive);
}

void ChangingSimulation::run(double until_s, observe::Audience& audience) {
  Relay relay{*this, audience, until_s};
  try {
    for (;;) {
      current_->run_before(relay, until_s);
      const auto [due, are_wishes] = relay.take();
      if (due.empty()) break;
      for (std::span<const Change> left{due}; !left.empty();) {
        const std::size_t many = are_wishes ? 1 : made_together(left);
        make(left.first(many), audience, until_s);
        left = left.subspan(many);
      }
    }
    audience.between_ticks(*this, true);
    audience.end(view());
  } catch (const std::exception& error) {
    if (!relay.has_failed()) audience.failure(error.what());
    throw;
  }
}

std::vector<Change> ChangingSimulation::scheduled_until(double time_s) {
  const auto later = std::ranges::find_if(schedule_, [&](const Change& change) { return change.time_s > time_s; });
  std::vector<Change> due{schedule_.begin(), later};
  schedule_.erase(schedule_.begin(), later);
  return due;
}

/// Whether these changes, made and to come, are those of the schedule.
bool ChangingSimulation::are_scheduled(const std::vector<observe::ParameterChange>& made,
                                       const std::vector<Change>& to_come) const {
  if (made.size() > schedule_.size()) return false;
  const auto first_to_come = schedule_.begin() + static_cast<std::ptrdiff_t>(made.size());
  if (!std::ranges::equal(first_to_come, schedule_.end(), to_come.begin(), to_come.end())) return false;
  const double tick_s = current_->view().tick_s;
  Values values;
  for (auto row = made.begin(); row != made.end();) {
    const std::span<const Change> left{schedule_.begin() + (row - made.begin()), schedule_.begin() + std::ssize(made)};
    const auto later = std::find_if(row, made.end(), [&](const auto& one) { return one.tick != row->tick; });
    const auto together = left.first(made_together(left.first(static_cast<std::size_t>(later - row))));
    const std::unique_ptr<Simulation> after = changed(values, together);
    for (const Change& planned : together) {
      const double late_s = row->time_s - planned.time_s;
      if (planned.number != row->number || late_s < 0.0 || late_s >= tick_s) return false;
      if (detail::value_in(after->describe(0.0), row->number) != row->value) return false;
      values[row->number] = row->value;
      ++row;
    }
  }
  return true;
}

/// The ecology of the parameters after changes of these values, at its start.
std::unique_ptr<Simulation> ChangingSimulation::changed(Values values, std::span<const Change> more) const {
  for (const Change& change : more) {
    const auto param = std::ranges::find(first_.named_params, change.number, &NamedParam::path);
    if (param != first_.named_params.end() && change.number.starts_with("rules.")) check_acts_later(*param, change.value);
    values[change.number] = change.value;
  }
  std::vector<Change> all;
  for (const auto& [number, value] : values) all.push_back({.number = number, .value = value});
  std::unique_ptr<Simulation> ecology = make_(all);
  const observe::RunDescription run = ecology->describe(0.0);
  for (const Change& change : more) {
    static_cast<void>(detail::value_in(run, change.number));
    if (!change.number.starts_with("rules.")) {
      throw std::invalid_argument{change.number + ": cannot change during a run; must be a rule parameter (rules. ...)"};
    }
  }
  check_may_follow(first_, run, false);
  return ecology;
}

/// Makes changes of different numbers at the present moment.
void ChangingSimulation::make(std::span<const Change> changes, observe::Audience& audience, double until_s) {
  std::unique_ptr<Simulation> next;
  try {
    if (made_.size() + changes.size() > most_changes)
      throw std::invalid_argument{"this run has " + std::to_string(made_.size()) +
                                  " changes: must have <= " + std::to_string(most_changes) + ", the most that can be replayed"};
    next = changed(values_, changes);
    Archive state;
    current_->persist(state);
    const std::string bytes = std::move(state).bytes();
    Archive same{bytes};
    next->persist(same);
    same.finish();
  } catch (const std::exception& error) {  // a RuleError, too: the bound of a value may be in another rule
    if (conductor_ == nullptr) throw;
    const Change& last = changes.back();
    const std::string why = error.what();
    const bool is_named = why.find(last.number) != std::string::npos;
    return conductor_->refused(last, is_named ? why : last.number + " = " + last.value + ": " + why);
  }
  const observe::RunDescription before = current_->describe(0.0);
  const observe::RunDescription after = next->describe(0.0);
  current_ = std::move(next);
  for (const Change& change : changes) {
    const observe::ParameterChange row{.time_s = current_->time_s(),
                                       .tick = current_->tick(),
                                       .number = change.number,
                                       .value = detail::value_in(after, change.number),
                                       .before = detail::value_in(before, change.number)};
    values_[row.number] = row.value;
    made_.push_back(row);
    if (journal_->table != nullptr) journal_->table->write(row);
    if (conductor_ != nullptr) conductor_->made(row);
  }
  audience.change(describe(until_s), view());
}

io::OwnTablesOf with_changes(const io::OwnTables& own_tables) {
  return [own_tables](const Simulation& ecology) {
    io::OwnTables all = own_tables;
    if (const auto* changing = dynamic_cast<const ChangingSimulation*>(&ecology)) all.push_back(changing->table());
    return all;
  };
}

}  // namespace trophic::changes
