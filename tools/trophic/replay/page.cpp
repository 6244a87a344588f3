// SPDX-License-Identifier: MIT
// Definitions of page.hpp.
#include <tools/trophic/replay/page.hpp>

#include <zlib.h>

#include <fstream>
#include <tools/reading/csv_reader.hpp>
#include <tools/trophic/replay/base64.hpp>
#include <tools/trophic/replay/director.hpp>
#include <trophic/support/json.hpp>

/// The viewer's page, tools/viewer/page, and its length: 0 in a program that is built with -DTROPHIC_VIEWER=OFF.
extern "C" {
extern const char trophic_viewer_page[];
extern const unsigned long trophic_viewer_page_size;
}

namespace trophic::command::replay {

std::string_view viewer_page() {
  if (trophic_viewer_page_size == 0) {
    throw std::invalid_argument{
        "this program was built without the viewer (-DTROPHIC_VIEWER=OFF); build it again with the viewer"};
  }
  return {static_cast<const char*>(trophic_viewer_page), trophic_viewer_page_size};
}

namespace {

std::string deflated(std::string_view text) {
  uLongf size = compressBound(static_cast<uLong>(text.size()));
  std::string bytes(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                static_cast<uLong>(text.size()), 9) != Z_OK) {
    throw std::runtime_error{"zlib cannot compress a table: out of memory"};
  }
  bytes.resize(size);
  return bytes;
}

/// A cell; one of more than nine characters that is a number with a fraction by four digits of it.
void append_short(std::string& text, std::string_view cell) {
  double value = 0.0;
  const bool is_long = cell.size() > 9 && cell.find('.') != std::string_view::npos;
  if (!is_long || std::from_chars(cell.data(), cell.data() + cell.size(), value).ptr != cell.data() + cell.size()) {
    text += cell;
    return;
  }
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 4);
  text.append(digits.data(), end.ptr);
}

/// The columns of a file but for those named, in the rows that `keep` says yes to; it is asked with the reader at the row, whose
/// first columns are `looked_at`. A truncated last line is left out. With `is_short` long numbers are shortened.
template <class Keep>
std::string table_without(const std::filesystem::path& path, const std::vector<std::string_view>& left_out,
                          std::initializer_list<std::string_view> looked_at, Keep&& keep, bool is_short = false) {
  analysis::CsvReader csv{path, looked_at};
  std::string header;
  {
    std::ifstream file{path};
    std::getline(file, header);
  }
  std::vector<std::size_t> places;
  std::string text;
  for (std::size_t at = 0; at <= header.size();) {
    const std::size_t end = std::min(header.find(',', at), header.size());
    const std::string name = header.substr(at, end - at);
    at = end + 1;
    if (std::ranges::find(left_out, name) != left_out.end()) continue;
    places.push_back(looked_at.size() + places.size());
    csv.want(name);
    text += (text.empty() ? "" : ",") + name;
  }
  while (csv.next()) {
    if (!keep(csv)) continue;
    text += '\n';
    for (const std::size_t place : places) {
      if (place != places.front()) text += ',';
      is_short ? append_short(text, csv.text(place)) : io::detail::append_cell(text, csv.text(place));
    }
  }
  return text += '\n';
}

/// Larger than any recording that a browser shows: in the page it is a text, of which browsers take half a gigabyte.
constexpr std::size_t most_recording_bytes = std::size_t{384} << 20U;

/// The blocks of a recording that a window touches, with those of bodies set down before its end; others are skipped, not read.
std::string recording_blocks(const RecordedRun& run, const Window& window) {
  const std::filesystem::path path = run.folder / "replay.trp";
  namespace format = io::recording;
  constexpr std::size_t front_bytes = 16;  // size and kind of a block, and the first and the number of its frames
  std::ifstream file{path, std::ios::binary};
  std::string kept(format::magic.size(), '\0');
  file.read(kept.data(), static_cast<std::streamsize>(kept.size()));
  std::string front(front_bytes, '\0');
  while (file.read(front.data(), front_bytes) || file.gcount() >= 12) {
    const std::size_t had = static_cast<std::size_t>(file.gcount());
    file.clear();
    const std::size_t size = std::size_t{12} + format::u32_at(front, 0);
    const std::string_view kind = std::string_view{front}.substr(4, 4);
    bool keep = kind == format::head_kind || kind == format::body_kind || (!window.from_s && !window.to_s);
    if (kind == format::who_kind && !keep) {
      keep = !window.to_s || run.recording.time_s(format::u32_at(front, 8)) <= *window.to_s + 1e-9;
    }
    if (kind == format::frames_kind && !keep) {
      const std::size_t first = format::u32_at(front, 8);
      const std::size_t last = first + format::u32_at(front, 12) - 1;
      keep = !(window.from_s && run.recording.time_s(last) < *window.from_s - 1e-9) &&
             !(window.to_s && run.recording.time_s(first) > *window.to_s + 1e-9);
    }
    if (!keep) {
      file.seekg(static_cast<std::streamoff>(size) - static_cast<std::streamoff>(had), std::ios::cur);
      continue;
    }
    if (kept.size() + size > most_recording_bytes) {
      throw std::invalid_argument{path.string() + ": has more than " + std::to_string(most_recording_bytes >> 20U) +
                                  " MiB of data: must be less for a page; shorten it with --from and --to"};
    }
    file.seekg(-static_cast<std::streamoff>(had), std::ios::cur);
    const std::size_t before = kept.size();
    kept.resize(before + size);
    if (!file.read(kept.data() + before, static_cast<std::streamsize>(size))) {
      kept.resize(before);  // truncated in the middle of a block
      break;
    }
  }
  return kept;
}

/// The recording in the page. Its frames are compressed, its bodies are not.
std::string recording_bytes(const RecordedRun& run, const Window& window) {
  const std::string blocks = recording_blocks(run, window);
  return run.recording.head().bodies_differ ? deflated(blocks) : blocks;
}

/// The names of heritable traits; none for a run without a rule Traits.
std::vector<std::string> trait_names(const RecordedRun& run) {
  std::vector<std::string> names;
  const Json rules = run.manifest.at("params").value("rules", Json::object());
  const Json traits = rules.value("traits", Json::object());
  for (const auto& [name, ignored] : traits.items()) names.push_back(name);
  return names;
}

/// The columns id and heritable traits of genomes.csv; empty for a run without them.
std::string traits_of(const RecordedRun& run, const std::vector<std::string>& traits) {
  if (traits.empty() || !std::filesystem::exists(run.folder / "genomes.csv")) return "";
  analysis::CsvReader genomes{run.folder / "genomes.csv", {"id"}};
  std::string text = "id";
  for (const std::string& name : traits) {
    genomes.want(name);
    text += "," + name;
  }
  while (genomes.next()) {
    text += '\n' + std::string{genomes.text(0)};
    for (std::size_t at = 1; at <= traits.size(); ++at) append_short(text += ',', genomes.text(at));
  }
  return text += '\n';
}

/// Files of a run in the page: (name, bytes).
std::vector<std::pair<std::string_view, std::string>> files_of(const RecordedRun& run, const Window& window) {
  const auto in_window = [&](const analysis::CsvReader& csv) { return window.has(csv.get<double>(0)); };
  const double tick_s = run.recording.head().times.tick_s;
  const auto ticks = [&](const analysis::CsvReader& csv) { return window.has_tick(csv.get<double>(0), tick_s); };
  const auto always = [](const analysis::CsvReader&) { return true; };
  std::vector<std::pair<std::string_view, std::string>> files;
  files.emplace_back("replay", recording_bytes(run, window));
  const std::vector<std::string> traits = trait_names(run);
  std::vector<std::string_view> elsewhere{"time_s", "origin", "x_m", "y_m", "heading_rad", "adversary_distance_m"};
  elsewhere.insert(elsewhere.end(), traits.begin(), traits.end());
  files.emplace_back("agents", deflated(table_without(run.folder / "agents.csv", elsewhere, {"time_s"}, ticks)));
  files.emplace_back("events",
                     deflated(table_without(run.folder / "events.csv", {"tick", "tag", "active", "genome_id", "ancestor_list"},
                                            {"time_s"}, in_window)));
  files.emplace_back("phylogeny", deflated(table_without(run.folder / "phylogeny.csv", {"ancestor_id"}, {}, always)));
  files.emplace_back("scenes", deflated(json_text(json_of_scenes(run, window))));
  if (std::filesystem::exists(run.folder / "senses.csv")) {
    files.emplace_back("senses",
                       deflated(table_without(run.folder / "senses.csv", {"time_s", "id", "species"}, {"time_s"}, ticks, true)));
  }
  if (std::filesystem::exists(run.folder / "states.csv")) {
    files.emplace_back("states", deflated(table_without(run.folder / "states.csv", {"time_s", "id"}, {"time_s"}, ticks, true)));
  }
  if (const std::string own = traits_of(run, traits); !own.empty()) files.emplace_back("traits", deflated(own));
  const auto moments = [&](const analysis::CsvReader& csv) { return window.has_tick(csv.get<double>(0), 100.0 * tick_s); };
  for (const auto& [name, table] : {std::pair{"energy", "energy.csv"}, {"food", "field.csv"}}) {
    if (!std::filesystem::exists(run.folder / table)) continue;
    files.emplace_back(name, deflated(table_without(run.folder / table, {"tick", "x_m", "y_m"}, {"time_s"}, moments, true)));
  }
  return files;
}

/// The shortest ends of the runs' paths that distinguish them: "replicate-00", or "paper/replicate-00" and
/// "released/replicate-00".
std::vector<std::string> labels_of(const std::vector<RecordedRun>& runs) {
  const auto label = [](const RecordedRun& run, std::size_t parts) {
    std::error_code error;
    std::filesystem::path rest = std::filesystem::weakly_canonical(run.folder, error).lexically_normal();
    if (error || rest.empty()) rest = run.folder.lexically_normal();
    if (!rest.has_filename()) rest = rest.parent_path();
    std::filesystem::path end;
    for (std::size_t i = 0; i < parts && rest.has_filename(); ++i, rest = rest.parent_path()) {
      end = end.empty() ? rest.filename() : rest.filename() / end;
    }
    return end.empty() ? run.folder.string() : end.string();
  };
  constexpr std::size_t most_parts = 8;
  std::vector<std::string> labels;
  for (std::size_t parts = 1; parts <= most_parts; ++parts) {
    labels.clear();
    for (const RecordedRun& run : runs) labels.push_back(label(run, parts));
    std::vector<std::string> sorted = labels;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end()) return labels;
  }
  return labels;
}

/// A run's entry in the page's index.
Json index_of(const RecordedRun& run, const Window& window, const std::string& label) {
  Json index = Json::object();
  if (window.from_s) index["from_s"] = *window.from_s;
  if (window.to_s) index["to_s"] = *window.to_s;
  index["label"] = label;
  if (run.manifest.contains("description")) {
    const Json& said = run.manifest["description"];
    index["name"] = said.at("name").get<std::string>();
    index["changes"] = Json::array();
    for (const Json& change : said.at("changes")) {
      Json& shown = index["changes"].emplace_back(Json{{"time_s", change.at("time_s").get<double>()}});
      for (const char* key : {"number", "value", "before"}) shown[key] = change.at(key).get<std::string>();
    }
  }
  const Json rules = run.manifest.value("rules", Json::object());
  index["rules"] = rules;
  if (rules.is_object() && rules.value("heredity", "") == "nothing_inherited") index["shadow"] = true;
  index["status"] = run.manifest.value("status", "unknown");
  index["species"] = run.manifest.at("species");
  index["tags"] = run.manifest.at("tags");
  if (run.manifest.contains("senses")) index["inputs"] = run.manifest["senses"].at("inputs");
  return index;
}

}  // namespace

std::string runs_part(const std::vector<RecordedRun>& runs, const Window& window) {
  Json index{{"title", "trophic:"}, {"runs", Json::array()}};
  const std::vector<std::string> labels = labels_of(runs);
  std::string files;
  for (std::size_t number = 0; number < runs.size(); ++number) {
    const RecordedRun& run = runs[number];
    try {
      index["runs"].push_back(index_of(run, window, labels[number]));
      for (const auto& [name, bytes] : files_of(run, window)) {
        files.append("<script type=\"text/plain\" data-run=\"").append(std::to_string(number)).append("\" data-file=\"");
        files.append(name).append("\">").append(base64(bytes)).append("</script>\n");
      }
    } catch (const Json::exception& error) {
      throw std::invalid_argument{(run.folder / "manifest.json").string() + ": " + reason_of(error)};
    } catch (const std::runtime_error& error) {
      throw std::invalid_argument{error.what()};
    }
    index["title"] = index["title"].get<std::string>() + " " + index["runs"].back()["label"].get<std::string>();
  }
  std::string json = json_text(index);
  for (std::size_t less = json.find('<'); less != std::string::npos; less = json.find('<', less))
    json.replace(less, 1, "\\u003c");
  return "<script type=\"application/json\" id=\"trophic-index\">" + json + "</script>\n" + files;
}

std::string page_of(const std::vector<RecordedRun>& runs, const Window& window) {
  const std::string_view viewer = viewer_page();
  constexpr std::string_view mark = "<!--RUNS-->";
  const std::size_t at = viewer.find(mark);
  if (at == std::string_view::npos) throw std::runtime_error{"the viewer's page has no place for runs"};
  std::string page{viewer.substr(0, at)};
  return page.append(runs_part(runs, window)).append(viewer.substr(at + mark.size()));
}

}  // namespace trophic::command::replay
