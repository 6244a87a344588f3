// SPDX-License-Identifier: MIT
// A user's program in one file: a rule table of one's own beside the paper's, and a CSV table of one's own in every run.
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/experiment.hpp>
#include <trophic/io/csv_file.hpp>
#include <trophic/rules/paper.hpp>

using Ageing = trophic::named<trophic::with_senescence<trophic::rules::Paper, trophic::death::senescence::OldAge>, "ageing">;

struct CrowdRow {
  double time_s = 0.0;
  std::size_t close = 0;
  static constexpr auto columns() {
    return std::tuple{trophic::io::column("time_s", &CrowdRow::time_s, "s", "the ecology's clock"),
                      trophic::io::column("close", &CrowdRow::close, "", "robots within 1 m of the arena's centre")};
  }
};

/// crowd.csv: how many robots are near the centre after each tick.
class Crowd {
 public:
  static constexpr std::string_view file_name = "crowd.csv";
  Crowd(const std::filesystem::path& path, trophic::Opening opening) : file_{path, opening} {}

  void on_tick(const trophic::View& view) {
    file_.write({.time_s = view.time_s, .close = view.within({.x_m = 0.0, .y_m = 0.0}, 1.0).size()});
    file_.flush();
  }
  void persist(trophic::Archive& archive) { archive(file_); }
  [[nodiscard]] trophic::io::TableSum sum() const { return file_.sum(); }

 private:
  trophic::io::CsvFile<CrowdRow> file_;
};

int main(int argc, char** argv) {
  return trophic::experiment<Ageing, trophic::rules::Paper>(argc, argv, trophic::io::own_tables<Crowd>());
}
