// SPDX-License-Identifier: MIT
// Completion in bash and zsh, written from a command's own options.
#pragma once

#include <string>
#include <string_view>
#include <tools/command/option.hpp>
#include <variant>
#include <vector>

namespace trophic::command {

namespace detail {

[[nodiscard]] inline bool is_named(const Option& option) {
  return option.name.starts_with('-');
}

/// Quotes a text for bash.
[[nodiscard]] inline std::string shell_text(std::string_view text) {
  std::string text_in_quotes = "'";
  for (const char c : text) text_in_quotes += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return text_in_quotes + "'";
}

[[nodiscard]] inline std::string lines(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "\n") + word;
  return shell_text(text);
}

/// Values that may follow an option, as a bash statement; empty for a flag.
[[nodiscard]] inline std::string values_of(const Option& option) {
  if (std::holds_alternative<bool*>(option.target)) return "";
  if (!option.words.empty()) {
    const bool assigned = option.use == Words::assigned;
    return (assigned ? "compopt -o nospace; offer " : "offer ") + lines(option.words) + (assigned ? " =" : "");
  }
  const bool text = std::holds_alternative<std::string*>(option.target) ||
                    std::holds_alternative<std::optional<std::string>*>(option.target) ||
                    std::holds_alternative<std::vector<std::string>*>(option.target);
  return text ? "offer_files" : ":";
}

/// The cases of one command: first its options with values, then what may stand anywhere else.
[[nodiscard]] inline std::string cases_of(const Command& command, std::string_view within) {
  std::string text;
  std::vector<std::string> anywhere{"--help"};
  std::string places;
  for (const Option& option : command.options) {
    const std::string values = values_of(option);
    if (!is_named(option)) {
      places = "; [[ $word == -* ]] || " + values;
      continue;
    }
    anywhere.push_back(option.name);
    if (values.empty()) continue;
    for (const std::string& name : {option.name, option.shorthand}) {
      if (!name.empty()) text += "    " + shell_text(std::string{within} + " " + name) + ") " + values + " ;;\n";
    }
  }
  if (within.empty()) {
    anywhere.insert(anywhere.end(), {"--version", "--completion"});
    text += "    ' --completion') offer " + lines({"bash", "zsh"}) + " ;;\n";
  }
  for (const Command& subcommand : command.subcommands) anywhere.push_back(subcommand.name);
  text += "    " + shell_text(within) + "' '*) offer " + lines(anywhere) + places + " ;;\n";
  return text;
}

}  // namespace detail

/// The script that `source <(PROGRAM --completion bash)` loads: options, subcommands, the words of options that have them, and
/// files elsewhere.
[[nodiscard]] inline std::string bash_completion(const Command& command, const std::string& program) {
  std::string function = "_";
  for (const char c : program) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    function += kept ? c : '_';
  }
  std::string names;
  std::string cases;
  for (const Command& subcommand : command.subcommands) {
    names += (names.empty() ? "" : "|") + subcommand.name;
    cases += detail::cases_of(subcommand, subcommand.name);
  }
  cases += detail::cases_of(command, "");
  std::string text = "# Completion of " + program + " in bash. Load it with: source <(" + program + " --completion bash)\n" +
                     function + "() {\n" + R"(  local IFS=$'\n' command= i
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  # bash splits --name=VALUE at the sign.
  if [[ $word == = ]]; then
    word=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  offer() { COMPREPLY+=($(compgen -S "${2-}" -W "$1" -- "$word")); }
  offer_files() { compopt -o filenames; COMPREPLY+=($(compgen -f -- "$word")); }
  COMPREPLY=()
)";
  if (!names.empty()) {
    text += "  for ((i = 1; i < COMP_CWORD; ++i)); do\n    case ${COMP_WORDS[i]} in\n      " + names +
            ") command=${COMP_WORDS[i]}; break ;;\n    esac\n  done\n";
  }
  return text + "  case \"$command $before\" in\n" + cases + "  esac\n  unset -f offer offer_files\n}\ncomplete -F " + function +
         " " + detail::shell_text(program) + "\n";
}

namespace detail {

/// A text within a specification of zsh's _arguments, in single quotes: brackets, colons and quotes have a meaning there.
[[nodiscard]] inline std::string zsh_escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c == '\'' ? std::string{"'\\''"} : std::string{c};
  }
  return result;
}

/// Returns zsh's completions of an option's value.
[[nodiscard]] inline std::string zsh_values(const Option& option) {
  if (std::holds_alternative<bool*>(option.target)) return "";
  std::string words;
  for (const std::string& word : option.words) words += (words.empty() ? "" : " ") + word;
  if (option.use == Words::assigned) return ":number:{compadd -S = -- " + words + "}";
  if (!words.empty()) return ":word:(" + words + ")";
  return values_of(option) == "offer_files" ? ":file:_files" : ":number: ";
}

/// The arguments of _arguments for a command, one a line.
[[nodiscard]] inline std::string zsh_arguments(const Command& command) {
  std::string text;
  for (const Option& option : command.options) {
    const bool is_list = std::holds_alternative<std::vector<std::string>*>(option.target);
    for (const std::string& name : {option.name, option.shorthand}) {
      if (name.empty()) continue;
      text += " \\\n    '";
      text += is_named(option) ? (is_list ? "*" : "") + name + "[" + zsh_escaped(option.help) + "]" + zsh_values(option)
                               : (is_list ? "*" : "1") + std::string{":"} + name + ":_files";
      text += "'";
    }
  }
  return text;
}

}  // namespace detail

/// The script that `source <(PROGRAM --completion zsh)` loads, with the help of each option.
[[nodiscard]] inline std::string zsh_completion(const Command& command, const std::string& program) {
  const std::string help = " \\\n    '(-h --help)'{-h,--help}'[print the help]'";
  std::string text = "#compdef " + program + "\n# Completion of " + program + " in zsh. Load it with: source <(" + program +
                     " --completion zsh)\n(( $+functions[compdef] )) || { autoload -Uz compinit && compinit; }\n_" + program +
                     "() {\n";
  if (!command.subcommands.empty()) {
    text += "  local -a commands=(";
    for (const Command& subcommand : command.subcommands) {
      text += "\n    '" + subcommand.name + ":" + detail::zsh_escaped(subcommand.about) + "'";
    }
    text += ")\n  if (( CURRENT == 2 )); then\n    _describe command commands\n  else\n    case $words[2] in\n";
    for (const Command& subcommand : command.subcommands) {
      text += "  " + subcommand.name + ") shift words; (( CURRENT-- )); _arguments -S" + help +
              detail::zsh_arguments(subcommand) + "; return ;;\n";
    }
    text += "    esac\n  fi\n";
  }
  return text + "  _arguments -S" + help +
         " \\\n    '--version[print the version]' \\\n    '--completion[print the completion]:shell:(bash zsh)'" +
         detail::zsh_arguments(command) + "\n}\ncompdef _" + program + " " + program + "\n";
}

}  // namespace trophic::command
