// SPDX-License-Identifier: MIT
// The extremes of every number: of all fields() of both rule tables, and of every file that is read. Each is refused or does its
// work within a limit on memory and time.
#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fuzz/readers.hpp>
#include <iterator>
#include <new>
#include <regex>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/reproduction/heredity/contract.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/support/whole_file.hpp>

namespace {

using namespace trophic;
using namespace trophic::test;

// AddressSanitizer maps terabytes.
#ifdef __has_feature
constexpr bool has_memory_limit = !__has_feature(address_sanitizer);
#else
constexpr bool has_memory_limit = true;
#endif

/// Does something in a process of its own with 1 GiB and so many seconds; what it died of, or empty.
template <class Work>
std::string fate_of(Work&& work, unsigned seconds) {
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit memory{std::uint64_t{1} << 30U, std::uint64_t{1} << 30U};
    if (has_memory_limit) ::setrlimit(RLIMIT_AS, &memory);
    ::alarm(seconds);
    try {
      work();
    } catch (const std::bad_alloc&) {
      ::_exit(2);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      ::_exit(3);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGALRM ? "too slow" : "signal " + std::to_string(WTERMSIG(status));
  return std::array<std::string, 4>{"", "1", "out of memory", "an exception of another type"}.at(WEXITSTATUS(status) & 3);
}

template <class P, class Visit>
void visit_numbers(P& params, Visit&& visit) {
  for_each_field(params, [&](const FieldText& text, auto& member) {
    using T = std::remove_cvref_t<decltype(member)>;
    if constexpr (HasFields<T>) {
      visit_numbers(member, visit);
    } else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      visit(text, member);
    }
  });
}

/// Values at and beyond what a field allows.
std::vector<double> extremes_of(const Bound& bound) {
  const double huge = std::numeric_limits<double>::max();
  const double none = std::numeric_limits<double>::infinity();
  std::vector<double> values{-1.0, 0.0, 1e-300, 1e-9, 1e9, 1e18, huge, none, std::nan("")};
  for (const double end : {bound.lower, bound.upper}) {
    if (std::isfinite(end)) values.insert(values.end(), {std::nextafter(end, -none), end, std::nextafter(end, none)});
  }
  return values;
}

template <class T>
void set_to(T& member, double value) {
  if constexpr (std::is_floating_point_v<T>) {
    member = value;
  } else {
    const auto most = static_cast<double>(std::numeric_limits<T>::max());
    const auto least = static_cast<double>(std::numeric_limits<T>::lowest());
    member = !(value > least)  ? std::numeric_limits<T>::lowest()
             : !(value < most) ? std::numeric_limits<T>::max()
                               : static_cast<T>(value);
  }
}

/// Three ticks of eight robots, whose tables have finite numbers; nothing if a number is refused.
template <class Rules>
void run_three_ticks(Experiment<Rules>& experiment, const backend::Kinematic::Params& backend);

/// With one number at an extreme.
template <class Rules>
void try_number(std::size_t which, std::size_t extreme) {
  Experiment<Rules> experiment;
  experiment.ecology.robots = 8;
  backend::Kinematic::Params backend;
  std::size_t number = 0;
  const auto set = [&](const FieldText& text, auto& member) {
    if (number++ == which) set_to(member, extremes_of(text.bound)[extreme]);
  };
  visit_numbers(experiment, set);
  visit_numbers(backend, set);
  run_three_ticks(experiment, backend);
}

template <class Rules>
void run_three_ticks(Experiment<Rules>& experiment, const backend::Kinematic::Params& backend) {
  try {
    validate(experiment, "");
    Ecology<Rules> ecology{experiment, backend};
    const TemporaryFolder folder;
    io::RunFolder files{folder.path() / "run",
                        {},
                        {.replay_hz = 0.0, .agents_every_ticks = 1, .senses = true, .states = true},
                        Opening::created,
                        ecology.state_columns()};
    ecology.run_until(3.0 * experiment.ecology.tick_s, files);
    for (const std::string& name : files.files()) {
      static const std::regex not_finite{"[,\\n]-?(inf|nan)"};
      static const std::regex alive{",inf,(prey|predator),"};  // destruction_time in phylogeny.csv
      if (std::regex_search(std::regex_replace(read_whole_file(files.path() / name), alive, ",,"), not_finite)) std::abort();
    }
    for (const GroundPose& pose : ecology.view().poses) {
      if (!std::isfinite(pose.x_m) || !std::isfinite(pose.y_m) || !std::isfinite(pose.heading_rad)) std::abort();
    }
  } catch (const std::invalid_argument&) {  // a sentence for the user
  } catch (const std::runtime_error&) {     // likewise
  } catch (const RuleError&) {              // likewise
  }
}

template <class Rules>
void check_extremes() {
  Experiment<Rules> experiment;
  backend::Kinematic::Params backend;
  std::vector<FieldText> numbers;
  const auto add = [&](const FieldText& text, auto&) { numbers.push_back(text); };
  visit_numbers(experiment, add);
  visit_numbers(backend, add);
  REQUIRE(numbers.size() > 25);
  for (std::size_t which = 0; which < numbers.size(); ++which) {
    CAPTURE(numbers[which].name);
    for (std::size_t extreme = 0; extreme < extremes_of(numbers[which].bound).size(); ++extreme) {
      CAPTURE(extremes_of(numbers[which].bound)[extreme]);
      const std::string fate = fate_of([&] { try_number<Rules>(which, extreme); }, 20);
      // Ten million robots may be asked for; they need the memory that they need.
      if (numbers[which].name != "robots") CHECK(fate == "");
      if (numbers[which].name == "robots") CHECK((fate.empty() || fate == "out of memory" || fate == "too slow"));
    }
  }
}

/// A text with each of its numbers at each extreme, of the first so many numbers.
std::vector<std::string> with_extreme_numbers(const std::string& text) {
  constexpr std::size_t most_numbers = 120;
  static const std::regex number{R"(-?[0-9]+(\.[0-9]+)?([eE][-+]?[0-9]+)?)"};
  std::vector<std::string> changed;
  std::size_t numbers = 0;
  for (std::sregex_iterator found{text.begin(), text.end(), number}; found != std::sregex_iterator{} && numbers < most_numbers;
       ++found, ++numbers) {
    for (const char* extreme :
         {"-1", "0", "1e18", "1e308", "-1e308", "4294967296", "9223372036854775807", "18446744073709551615"}) {
      changed.push_back(text);
      changed.back().replace(static_cast<std::size_t>(found->position()), static_cast<std::size_t>(found->length()), extreme);
    }
  }
  return changed;
}

/// Bytes with a whole number of 4 or 8 bytes at each place of their beginning at each extreme.
std::vector<std::string> with_extreme_bytes(const std::string& bytes) {
  constexpr std::size_t most_places = 400;
  std::vector<std::string> changed;
  for (std::size_t at = 0; at + 8 <= bytes.size() && at < most_places; ++at) {
    for (const std::uint64_t extreme :
         {std::uint64_t{0}, std::uint64_t{0xFFFF'FFFF}, std::uint64_t{1} << 40U, ~std::uint64_t{0}}) {
      for (const std::size_t size : {std::size_t{4}, std::size_t{8}}) {
        changed.push_back(bytes);
        std::memcpy(changed.back().data() + at, &extreme, size);
      }
    }
  }
  return changed;
}

bool is_text(const std::string& bytes) {
  return bytes.find('\0') == std::string::npos;
}

/// Inherits half of the weights.
struct Shortening {
  static constexpr std::string_view name = "shortening";
  struct Params {};
  Params params;
  [[nodiscard]] std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const {
    auto child = std::make_shared<Genome>(*parent);
    child->weights.resize(child->weights.size() / 2);
    return child;
  }
};

}  // namespace

TEST_CASE("numbers: every field of the paper's table at its extremes -> refused, or run within 1 GiB and 20 s") {
  check_extremes<rules::Paper>();
}

TEST_CASE("numbers: every field of the released table at its extremes -> refused, or run within 1 GiB and 20 s") {
  check_extremes<rules::Released>();
}

TEST_CASE("numbers: those of a rule with spare bodies at their extremes -> refused, or run within 1 GiB and 20 s") {
  Experiment<Recruited> experiment;
  std::vector<Bound> bounds;
  visit_numbers(experiment.rules.recruitment, [&](const FieldText& text, auto&) { bounds.push_back(text.bound); });
  REQUIRE(bounds.size() == 4);
  for (std::size_t which = 0; which < bounds.size(); ++which) {
    for (const double extreme : extremes_of(bounds[which])) {
      CAPTURE(which);
      CAPTURE(extreme);
      CHECK(fate_of(
                [&] {
                  std::size_t number = 0;
                  Experiment<Recruited> changed;
                  changed.ecology.robots = 8;
                  visit_numbers(changed.rules.recruitment, [&](const FieldText&, auto& member) {
                    if (number++ == which) set_to(member, extreme);
                  });
                  run_three_ticks(changed, backend::Kinematic::Params{});
                },
                20) == "");
    }
  }
}

TEST_CASE("numbers: every number of every file at extremes -> refused, or read within 1 GiB and a minute") {
  for (const Reader& reader : readers) {
    CAPTURE(reader.name);
    std::vector<std::string> cases;
    for (const auto& entry : std::filesystem::directory_iterator{std::filesystem::path{CORPUS} / reader.name}) {
      std::ifstream file{entry.path(), std::ios::binary};
      const std::string bytes{std::istreambuf_iterator<char>{file}, {}};
      auto more = is_text(bytes) ? with_extreme_numbers(bytes) : with_extreme_bytes(bytes);
      cases.insert(cases.end(), more.begin(), more.end());
    }
    REQUIRE(!cases.empty());
    CHECK(fate_of(
              [&] {
                for (const std::string& bytes : cases) try_reader(reader, bytes);
              },
              60) == "");
  }
}

TEST_CASE("files of any size: a file without the beginning of its kind -> refused before it is read") {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / ("trophic-sparse-" + std::to_string(::getpid()));
  std::ofstream{path}.close();
  std::filesystem::resize_file(path, std::uint64_t{20} << 30U);
  const auto read_all = [&] {
    const auto refuses = [](auto&& read) {
      try {
        read();
      } catch (const std::bad_alloc&) {
        throw;
      } catch (const std::exception&) {
        return;
      }
      std::abort();
    };
    const FoodWeb web = fuzzed_web();
    refuses([&] { static_cast<void>(io::RecordingReader{path}); });
    refuses([&] { static_cast<void>(analysis::TableReader<io::EventRow>{path, web}); });
    refuses([&] { static_cast<void>(load_robot(path.string())); });
    refuses([&] { static_cast<void>(load_arena(path.string())); });
    refuses([&] { static_cast<void>(load_gait(path.string())); });
    refuses([&] { static_cast<void>(plan::read_plan(path)); });
    const std::filesystem::path folder = path.string() + ".folder";
    std::filesystem::create_directory(folder);
    std::filesystem::rename(path, folder / "checkpoint.bin");
    refuses([&] { static_cast<void>(checkpoint::read_last(folder)); });
    std::filesystem::rename(folder / "checkpoint.bin", folder / "manifest.json");
    refuses([&] { static_cast<void>(analysis::read_manifest(folder)); });
    std::filesystem::remove_all(folder);
  };
  CHECK(fate_of(read_all, 20) == "");
  std::filesystem::remove(path);
  std::filesystem::remove_all(path.string() + ".folder");
}

TEST_CASE("heredity: a genome of another length -> RuleError that names both lengths") {
  Experiment<with_heredity<rules::Paper, Shortening>> experiment;
  experiment.seed = 3;
  Ecology<with_heredity<rules::Paper, Shortening>> ecology{experiment, backend::Kinematic::Params{}};
  std::string said;
  try {
    ecology.run_until(3000.0);
  } catch (const RuleError& error) {
    said = error.what();
  }
  CHECK(said.find("heredity") != std::string::npos);
  CHECK(said.find(" weights: must have ") != std::string::npos);
}

TEST_CASE("clock: ticks of 0.7 s -> decimal times, and a run of 2.1 s has three") {
  CHECK(clock_s(3, 0.7) == 2.1);
  CHECK(clock_s(10, 0.7) == 7.0);
  CHECK(clock_s(1'000'003, 2.0) == 2'000'006.0);
  CHECK(clock_s(3, 1.0 / 3.0) == 3.0 * (1.0 / 3.0));
  CHECK(clock_s(std::int64_t{1} << 60U, 2.0) == static_cast<double>(std::int64_t{1} << 61U));
  CHECK(has_passed(clock_s(12, 0.7) - clock_s(2, 0.7), 7.0, 0.7));
  CHECK_FALSE(has_passed(clock_s(11, 0.7) - clock_s(2, 0.7), 7.0, 0.7));
  Experiment<rules::Paper> experiment;
  experiment.ecology.tick_s = 0.7;
  Ecology<rules::Paper> ecology{experiment, backend::Kinematic::Params{}};
  ecology.run_until(2.1);
  CHECK(ecology.tick() == 3);
}
