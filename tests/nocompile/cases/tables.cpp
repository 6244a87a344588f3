// SPDX-License-Identifier: MIT
// Two own tables.
#include <trophic/io/own_table.hpp>

struct CrowdRow {
  std::int64_t tick = 0;
  static constexpr auto columns() { return std::tuple{trophic::io::column("tick", &CrowdRow::tick, "", "the tick")}; }
};

struct Crowd {
  static constexpr std::string_view file_name = "crowd.csv";
  Crowd(const std::filesystem::path& path, trophic::Opening opening) : file_{path, opening} {}
  void on_tick(const trophic::View& view) { file_.write({view.tick}); }
  void persist(trophic::Archive& archive) { archive(file_); }
  [[nodiscard]] trophic::io::TableSum sum() const { return file_.sum(); }

 private:
  trophic::io::CsvFile<CrowdRow> file_;
};

struct Ticks : Crowd {
  using Crowd::Crowd;
  static constexpr std::string_view file_name = "ticks.csv";
};

int main() {
  return trophic::io::own_tables<Crowd, Ticks>().size() == 2 ? 0 : 1;
}
