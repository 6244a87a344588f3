// SPDX-License-Identifier: MIT
// `trophic contest`: hunters of one epoch against victims of another, and the progress that their contests show.
#include "commands.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <mutex>
#include <set>
#include <thread>
#include <tools/command/output.hpp>
#include <tools/command/result_folder.hpp>
#include <tools/command/run_python.hpp>
#include <tools/contest/play_contests.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <tools/trophic/shipped_offer.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/checksum.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/new_file.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/whole_file.hpp>

#include "contest/planned_contests.hpp"

extern char** environ;

namespace trophic::command {

namespace detail::contest_command {

struct Options {
  std::vector<std::string> runs;
  std::optional<std::string> shadow;
  std::optional<std::string> panel;
  std::string epochs;
  std::string against = "others";
  std::uint64_t teams = 6;
  std::optional<std::uint64_t> team_size;
  double duration_s = 300.0;
  double reach_m = 1.0;
  std::optional<double> split_s;
  std::uint64_t seed = 1;
  std::optional<std::string> backend;
  std::string program;
  std::optional<std::uint64_t> jobs;
  std::optional<std::string> out;
  bool accept_other_build = false;
};

[[nodiscard]] std::vector<double> epochs_of(const std::string& text) {
  std::vector<double> epochs_s;
  for (std::size_t at = 0; !text.empty() && at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    double value = 0.0;
    const auto parsed = std::from_chars(text.data() + at, text.data() + end, value);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + end || !std::isfinite(value)) {
      throw std::invalid_argument{"--epochs " + text + ": must be times in seconds with commas between, as 0,2000,6000"};
    }
    epochs_s.push_back(value);
    at = end + 1;
  }
  return epochs_s;
}

[[nodiscard]] std::vector<contest::Against> against_of(const Options& options) {
  using contest::Against;
  const std::string& text = options.against;
  if (options.panel) return {};
  if (text == "own") return {Against::own};
  if (text == "others") return {Against::others};
  return {Against::own, Against::others};
}

void check(const Options& options) {
  const auto positive = [](const char* option, double value) {
    if (value > 0.0 && value <= longest_run_s) return;
    throw std::invalid_argument{std::string{option} + " " + number_text(value) +
                                ": must be > 0 and <= " + number_text(longest_run_s)};
  };
  positive("--duration", options.duration_s);
  positive("--reach", options.reach_m);
  if (options.teams < 2) {
    throw std::invalid_argument{"--teams " + std::to_string(options.teams) +
                                ": must be >= 2; what a single team does is not what its epoch does"};
  }
  if (options.teams > 1000) throw std::invalid_argument{"--teams " + std::to_string(options.teams) + ": must be <= 1000"};
  if (options.team_size && (*options.team_size < 1 || *options.team_size > 10'000)) {
    throw std::invalid_argument{"--team-size " + std::to_string(*options.team_size) + ": must be >= 1 and <= 10000"};
  }
  if (options.jobs == std::uint64_t{0}) throw std::invalid_argument{"--jobs 0: must be >= 1"};
}

/// A file that is removed at the end.
class Passing {
 public:
  explicit Passing(std::filesystem::path path) : path_{std::move(path)} {}
  Passing(const Passing&) = delete;
  Passing& operator=(const Passing&) = delete;
  ~Passing() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The outcomes of contests as they are played, a line each, so that the same command continues what was killed.
class PlayedFile {
 public:
  static constexpr const char* name = "played.jsonl";

  /// Reads what a program left that played the same plan.
  PlayedFile(const std::filesystem::path& folder, const contest::Plan& plan) : outcomes_(plan.matches.size()) {
    const std::filesystem::path path = folder / name;
    const std::string head = "[" + std::to_string(checksum(contest::text_of(plan))) + "]\n";
    const std::string there = std::filesystem::exists(path) ? read_whole_file(path) : "";
    std::string whole = head;
    for (std::size_t at = there.starts_with(head) ? head.size() : there.size(); at < there.size();) {
      const std::size_t end = there.find('\n', at);
      if (end == std::string::npos) break;  // cut short
      const Json line = parse_json_or_null(std::string_view{there}.substr(at, end - at));
      if (!line.is_array() || line.size() != 3 || !line[0].is_number_unsigned() || line[0] >= Json(outcomes_.size())) break;
      outcomes_[line[0].get<std::size_t>()] = {.contact_s = line[1].get<double>(), .contacted = line[2].get<double>()};
      whole += there.substr(at, end + 1 - at);
      at = end + 1;
    }
    path_ = path;
    begun_ = std::move(whole);
  }

  [[nodiscard]] const Outcomes& outcomes() const { return outcomes_; }
  void add(std::size_t match, const contest::Outcome& outcome) {
    const std::scoped_lock alone{lock_};
    if (!file_) {
      replace_file(path_, begun_);
      file_.emplace(path_, Opening::resumed);
    }
    file_->append(json_text(Json{match, outcome.contact_s, outcome.contacted}) + "\n");
  }

 private:
  Outcomes outcomes_;
  std::filesystem::path path_;
  std::string begun_;  ///< what the file begins with: there is none before the first outcome
  std::mutex lock_;
  std::optional<GrowingFile> file_;
};

/// Lets another program play the plan, by `PROGRAM --play PLAN`. None if a signal stopped it.
[[nodiscard]] Outcomes played_by(const std::string& program, const contest::Plan& plan, const std::filesystem::path& folder,
                                 std::size_t jobs) {
  const Passing file{folder / "plan.json"};
  const Passing outcomes{outcomes_of(file.path())};
  write_new_file(file.path(), contest::text_of(plan));
  std::vector<std::string> words{program, "--play", file.path().string(), "--jobs", std::to_string(jobs)};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  std::cout.flush();
  const int failed = ::posix_spawnp(&process, program.c_str(), nullptr, nullptr, arguments.data(), environ);
  if (failed != 0) throw std::invalid_argument{"--program " + program + ": " + std::strerror(failed)};
  int status = 0;
  const replicates::StopOnSignal stop;
  for (bool is_told = false; ::waitpid(process, &status, WNOHANG) == 0;) {
    if (!stop.keep_running() && !std::exchange(is_told, true)) ::kill(process, SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
  }
  if (!stop.keep_running()) return Outcomes(plan.matches.size());
  const std::string who = "--program " + program + ": did not play the contests";
  if (WIFSIGNALED(status)) throw std::runtime_error{who + ": ended by signal " + std::to_string(WTERMSIG(status))};
  if (WEXITSTATUS(status) == stopped) throw std::runtime_error{who + ": stopped by a signal"};
  if (WEXITSTATUS(status) != 0) throw std::invalid_argument{who + "; its message is above"};
  if (!std::filesystem::exists(outcomes.path())) throw std::invalid_argument{who + ", but ended without an error"};
  const auto read = contest::read_outcomes(outcomes.path(), plan.matches.size());
  return {read.begin(), read.end()};
}

/// Throws std::invalid_argument unless a split is one of the epochs.
void check_split(double split_s, std::span<const contest::ContestRow> rows) {
  std::set<double> epochs_s;
  for (const contest::ContestRow& row : rows) epochs_s.insert(row.hunter_epoch_s);
  if (epochs_s.contains(split_s)) return;
  std::string all;
  for (const double epoch_s : epochs_s) all += (all.empty() ? "" : ", ") + number_text(epoch_s);
  throw std::invalid_argument{"--split " + number_text(split_s) + ": must be one of the epochs, " + all + " s"};
}

[[nodiscard]] int run(const Options& options) {
  check(options);
  const std::vector<std::filesystem::path> runs{options.runs.begin(), options.runs.end()};
  auto sets = contests::read_sets(runs, options.shadow, options.accept_other_build);
  if (options.panel) contests::add_panel(sets, *options.panel, options.accept_other_build);
  for (const std::string& remark : sets.remarks) std::cerr << "trophic contest: " << remark << "\n";
  contests::Planned planned = contests::planned_contests(sets, {.epochs_s = epochs_of(options.epochs),
                                                                .against = against_of(options),
                                                                .teams = options.teams,
                                                                .team_size = options.team_size.value_or(0),
                                                                .duration_s = options.duration_s,
                                                                .reach_m = options.reach_m,
                                                                .seed = options.seed});
  if (options.backend && *options.backend != planned.plan.engine) {
    planned.plan.engine = *options.backend;
    planned.plan.fingerprint.clear();
    planned.plan.params.erase("backend");
  }
  if (options.split_s) check_split(*options.split_s, planned.rows);
  const Offer offer = shipped_offer();
  if (options.program.empty()) {
    if (const std::string why = why_not_played(planned.plan, offer); !why.empty()) {
      throw std::invalid_argument{sets.ours.front().folder.string() + ": " + why};
    }
  }
  const std::size_t jobs = options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency()));
  const std::string out = options.out.value_or(io::next_free_folder("contests").string());
  ResultFolder folder{out, PlayedFile::name};
  PlayedFile played{folder.path(), planned.plan};
  const auto before = std::ranges::count_if(played.outcomes(), [](const auto& one) { return one.has_value(); });
  if (before > 0) std::cout << before << " of " << played.outcomes().size() << " contests were played already" << std::endl;
  const auto start = std::chrono::steady_clock::now();
  const auto add = [&](std::size_t match, const contest::Outcome& outcome) { played.add(match, outcome); };
  const Outcomes outcomes = options.program.empty() ? play(planned.plan, offer, jobs, played.outcomes(), add)
                                                    : played_by(options.program, planned.plan, folder.path(), jobs);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!outcomes[i]) {
      std::cout << "stopped by signal " << replicates::StopOnSignal::caught() << "; the same command with --out " << out
                << " continues" << std::endl;
      return stopped;
    }
    planned.rows[i].contact_s = outcomes[i]->contact_s;
    planned.rows[i].contacted = outcomes[i]->contacted;
  }
  std::string table = io::header_of<contest::ContestRow>();
  for (const contest::ContestRow& row : planned.rows) io::append_row(table, row, FoodWeb{{}, {}});
  write_new_file(folder.path() / "contests.csv", table);
  return run_python({{"command", "contest"},
                     {"who", "trophic contest"},
                     {"folder", folder.path().string()},
                     {"out", out},
                     {"split_s", options.split_s ? Json(*options.split_s) : Json()},
                     {"duration_s", options.duration_s},
                     {"taken_s", taken.count()}});
}

}  // namespace detail::contest_command

/// Contests across generations.
Command contest_command() {
  using detail::contest_command::Options;
  const auto options = std::make_shared<Options>();
  return {
      .name = "contest",
      .about =
          "Lets hunters of one epoch of the runs meet victims of another, in the runs' arena without catches, births and deaths. "
          "Progress of a species is how much sooner its later hunters reach the victims of all epochs, or how much later its "
          "later victims are reached; against opponents of other replicates it is global, against those from the same run "
          "historical. It is compared with the neutral shadow, which is found in RUNS/shadow. Needs Python with pandas and "
          "scipy.",
      .options = {{.name = "runs", .target = &options->runs, .help = "folders of runs, or of replicates", .required = true},
                  {"--shadow", &options->shadow, "folder of the shadow (RUNS/shadow, if there is one)"},
                  {"--epochs", &options->epochs,
                   "times of the runs, with commas between, as 0,2000,6000 (four, evenly over the runs)"},
                  {"--against",
                   &options->against,
                   "opponents: others, of another replicate; own; or both (others)",
                   {"others", "own", "both"}},
                  {"--panel", &options->panel, "folder of runs whose last living are the opponents of all, instead of --against"},
                  {"--split", &options->split_s, "the epoch at which the late period begins (that in the middle)"},
                  {"--teams", &options->teams, "teams drawn for each epoch and species, at least 2 (6)"},
                  {"--team-size", &options->team_size, "robots in a team (half of the runs' robots)"},
                  {"--duration", &options->duration_s, "length of a contest, seconds of the ecology's clock (300)"},
                  {"--reach", &options->reach_m, "distance in metres at which a hunter reaches a victim (1)"},
                  {"--seed", &options->seed, "of teams, partners and places (1)"},
                  {"--backend", &options->backend, "play on this backend, with its default parameters (the runs')"},
                  {"--program", &options->program, "the program that made the runs, if their rule table is your own"},
                  {"--jobs", &options->jobs, "contests at a time (one per core); results do not depend on it"},
                  {"--accept-other-build", &options->accept_other_build, "take runs that several builds of a program made"},
                  {"--out", &options->out,
                   "new folder for contests.csv and progress.csv (the next free contests, contests-1, ...)"}},
      .work = [options] { return detail::contest_command::run(*options); },
      .examples = {"trophic contest runs/study", "trophic contest runs/study --against both --epochs 0,2000,4000,6000",
                   "trophic contest runs/mine --program build/my_experiment"}};
}

}  // namespace trophic::command
