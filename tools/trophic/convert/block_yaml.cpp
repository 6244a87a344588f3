// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tools/trophic/convert/block_yaml.hpp>
#include <vector>

namespace trophic::convert {

namespace {

struct Line {
  std::size_t number;
  std::size_t indent;
  std::string text;  ///< without indentation and comment
};

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : file_{file} {
    std::size_t number = 0;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      add_line(++number, text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  [[nodiscard]] Json read() {
    const auto body = std::ranges::find_if(
        lines_, [](const Line& line) { return line.indent == 0 && (line.text == "body:" || line.text.starts_with("body: ")); });
    if (body != lines_.end()) {
      const auto end = std::find_if(body + 1, lines_.end(), [](const Line& line) { return line.indent == 0; });
      lines_ = std::vector<Line>{body, end};
    }
    return read_object(0);
  }

 private:
  static constexpr std::size_t most_levels = 128;
  static constexpr std::size_t most_keys = 100;  ///< of one object

  [[noreturn]] void fail(const Line& line, const std::string& what) const {
    throw std::invalid_argument{file_ + ":" + std::to_string(line.number) + ": " + what};
  }

  void add_line(std::size_t number, std::string_view whole) {
    const std::size_t indent = std::min(whole.find_first_not_of(' '), whole.size());
    char quote = '\0';
    std::size_t end = indent;
    for (; end < whole.size(); ++end) {
      const char c = whole[end];
      if (quote == '\0' && c == '#' && (end == 0 || whole[end - 1] == ' ')) break;
      if (quote != '\0' ? c == quote : (c == '\'' || c == '"')) quote = quote == '\0' ? c : '\0';
    }
    while (end > indent && (whole[end - 1] == ' ' || whole[end - 1] == '\r')) --end;
    const std::string_view text = whole.substr(indent, end - indent);
    if (text.empty() || (indent == 0 && (text.starts_with("---") || text.starts_with('%')))) return;
    lines_.push_back({number, indent, std::string{text}});
  }

  /// The text without its quotes.
  [[nodiscard]] std::string plain(const Line& line, std::string_view text) const {
    if (text.find_first_of("&*!|>@`") == 0) fail(line, std::string{text} + ": is YAML that Revolve does not write");
    const bool quoted = text.size() > 1 && (text.front() == '\'' || text.front() == '"') && text.back() == text.front();
    if (quoted) text = text.substr(1, text.size() - 2);
    if (text.find_first_of("\"'") != std::string_view::npos || (quoted && text.find('\\') != std::string_view::npos)) {
      fail(line, std::string{text} + ": must be a text without quotes within");
    }
    return std::string{text};
  }

  /// A value in brackets, which may continue on the next lines.
  [[nodiscard]] std::string bracketed(const Line& line, std::string text) {
    const auto opened = [](std::string_view part) {
      return std::ranges::count_if(part, [](char c) { return c == '{' || c == '['; }) -
             std::ranges::count_if(part, [](char c) { return c == '}' || c == ']'; });
    };
    auto depth = opened(text);
    for (; depth > 0; ++at_) {
      if (at_ == lines_.size()) fail(line, "a bracket is not closed");
      depth += opened(lines_[at_].text);
      text.append(" ").append(lines_[at_].text);
    }
    if (depth < 0) fail(line, "a bracket too many");
    return text;
  }

  /// The lines from `at_` on that have the indentation of the first; deeper ones belong to the one before them.
  [[nodiscard]] Json read_object(std::size_t level) {
    Json object = Json::object();
    if (at_ == lines_.size()) return object;
    if (level > most_levels) fail(lines_[at_], "nested more than " + std::to_string(most_levels) + " deep");
    const std::size_t indent = lines_[at_].indent;
    while (at_ < lines_.size() && lines_[at_].indent >= indent) {
      const Line line = lines_[at_++];
      if (line.indent > indent) fail(line, "must be indented as the line before");
      std::size_t colon = line.text.find(": ");
      if (colon == std::string::npos && line.text.ends_with(':')) colon = line.text.size() - 1;
      if (colon == std::string::npos || line.text.starts_with('-') || line.text.find('\t') != std::string::npos) {
        fail(line, "must be KEY: VALUE, indented by spaces");
      }
      std::string name = line.text.substr(0, colon);
      name.erase(name.find_last_not_of(' ') + 1);
      const std::string key = plain(line, name);
      if (object.contains(key)) fail(line, key + ": appears twice");
      if (object.size() == most_keys) fail(line, "more than " + std::to_string(most_keys) + " keys");
      const std::size_t begin = line.text.find_first_not_of(' ', colon + 1);
      if (begin != std::string::npos) {
        const std::string value = line.text.substr(begin);
        object[key] = value.front() == '{' || value.front() == '[' ? bracketed(line, value) : plain(line, value);
      } else if (at_ < lines_.size() && lines_[at_].indent > indent) {
        object[key] = read_object(level + 1);
      } else {
        object[key] = nullptr;
      }
    }
    return object;
  }

  const std::string& file_;
  std::vector<Line> lines_;
  std::size_t at_ = 0;
};

}  // namespace

Json read_block_yaml(std::string_view text, const std::string& file) {
  return Reader{text, file}.read();
}

}  // namespace trophic::convert
