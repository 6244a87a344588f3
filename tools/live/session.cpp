// SPDX-License-Identifier: MIT
// trophic::live::open: the page, the server, the steering and the observer of runs together.
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string_view>
#include <tools/command/output.hpp>
#include <tools/live/live_server.hpp>
#include <tools/live/server.hpp>
#include <tools/live/sight.hpp>
#include <tools/live/steering.hpp>
#include <tools/live/wishes.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <utility>

/// The viewer's page, tools/viewer/page, and its length: 0 in a program that is built with -DTROPHIC_VIEWER=OFF.
extern "C" {
extern const char trophic_viewer_page[];
extern const unsigned long trophic_viewer_page_size;
}

namespace trophic::live {

namespace {

/// How long a run that has ended waits for a page that is loaded again.
constexpr double page_grace_s = 2.0;

void put_in(std::string& page, std::string_view before, std::string_view text) {
  const std::size_t at = page.find(before);
  if (at == std::string::npos)
    throw std::invalid_argument{"--live: this program was built without the viewer (-DTROPHIC_VIEWER=OFF)"};
  page.replace(at, before.size(), text);
}

/// The viewer's page without runs, which it gets by its web socket.
std::string live_page() {
  std::string page{static_cast<const char*>(trophic_viewer_page), trophic_viewer_page_size};
  put_in(page, "img-src data: blob:", "img-src data: blob:; connect-src 'self'");
  put_in(page, "<!--RUNS-->",
         "<script type=\"application/json\" id=\"trophic-index\">{\"title\": \"trophic, live\", \"live\": true, \"runs\": "
         "[]}</script>\n");
  return page;
}

class Session final : public command::LiveServer, private Listener {
 public:
  explicit Session(std::uint16_t port)
      : steering_{*this},
        server_{port,
                live_page(),
                {.pages = [this](std::size_t pages) { count(pages); },
                 .wish = [this](const std::string& message) { return follow(message); },
                 .state = [this](std::size_t told) { return state(told); }}},
        sight_{server_, steering_} {
    std::cout << "live    " << server_.address()
              << "\n        open it in a browser on this machine to start the run. From another machine, first run: ssh -L "
              << server_.port() << ":127.0.0.1:" << server_.port() << " HOST" << std::endl;
    command::flush_output();  // without its address no user opens the page, and the run waits for ever
  }

  void begin(const command::LiveRun& run) override {
    {
      const std::lock_guard lock{mutex_};
      run_ = run;
      is_over_ = false;
      failure_.clear();
    }
    begun_.notify_all();
    sight_.begin(run);
  }
  [[nodiscard]] changes::Conductor& conductor() override { return steering_; }
  void run_with_checkpoints(Simulation& ecology, double until_s, const std::filesystem::path& folder,
                            const checkpoint::Schedule& schedule, const std::optional<checkpoint::Checkpoint>& from,
                            io::RunFolder& files, observe::Progress& progress, const replicates::StopOnSignal& stop) override {
    checkpoint::run_with_checkpoints(ecology, until_s, folder, schedule, from, files, progress, stop, sight_);
  }
  void failed(const std::string& why) override {
    const std::lock_guard lock{mutex_};
    failure_ = "The run ended: " + why;
    refused(failure_);
  }
  [[nodiscard]] std::optional<command::Restart> next() override {
    {
      const std::lock_guard lock{mutex_};
      is_over_ = true;
    }
    server_.tell_state();
    return steering_.wait_for_restart(page_grace_s);
  }

 private:
  void refused(const std::string& why) override { server_.tell(message_of({{"kind", "refused"}, {"text", why}})); }

  /// A page that comes after a failure hears of it, too.
  void count(std::size_t pages) {
    steering_.set_pages(pages);
    const std::lock_guard lock{mutex_};
    if (!failure_.empty()) refused(failure_);
  }

  [[nodiscard]] Json state(std::size_t told) {
    const Pace pace = steering_.pace();
    Json changes = Json::array();
    const auto [name, made] = steering_.rules();
    const std::size_t from = told <= made.size() ? told : 0;
    for (std::size_t i = from; i < made.size(); ++i) {
      const observe::ParameterChange& one = made[i];
      changes.push_back({{"time_s", one.time_s}, {"number", one.number}, {"value", one.value}, {"before", one.before}});
    }
    const std::lock_guard lock{mutex_};
    return {{"paused", pace.is_paused}, {"speed", pace.speed},          {"over", is_over_}, {"name", name},
            {"changes_from", from},     {"changes", std::move(changes)}};
  }

  /// Does what a page asks for. Returns the sentence of the refusal, empty if there is none.
  [[nodiscard]] std::string follow(const std::string& message) {
    command::LiveRun run;
    bool is_over = false;
    {
      // A page may ask before the run begins, as its address is printed first.
      std::unique_lock lock{mutex_};
      const auto has_begun = [&] { return !run_.rule_table.empty(); };
      if (!begun_.wait_for(lock, std::chrono::seconds{10}, has_begun)) return "The run has not begun; ask again.";
      run = run_;
      is_over = is_over_;
    }
    try {
      const Wish wish = read_wish(message, run);
      if (is_over && wish.kind != Wish::Kind::restart) return "This run has ended; start another one.";
      take(wish);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    server_.tell_state();
    return "";
  }
  void take(const Wish& wish) {
    switch (wish.kind) {
      case Wish::Kind::play:
        return steering_.play();
      case Wish::Kind::pause:
        return steering_.pause();
      case Wish::Kind::tick:
        return steering_.step();
      case Wish::Kind::speed:
        return steering_.set_speed(wish.speed);
      case Wish::Kind::set:
        return steering_.change({.time_s = 0.0, .number = wish.number, .value = wish.value});
      case Wish::Kind::restart:
        return steering_.restart(wish.seed, wish.rule_table);
    }
  }

  std::mutex mutex_;
  std::condition_variable begun_;
  command::LiveRun run_;  ///< its rule table is empty before it begins
  bool is_over_ = false;
  std::string failure_;
  Steering steering_;
  Server server_;
  Sight sight_;
};

}  // namespace

std::unique_ptr<command::LiveServer> open(std::uint16_t port) {
  return std::make_unique<Session>(port);
}

}  // namespace trophic::live
