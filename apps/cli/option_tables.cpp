// SPDX-License-Identifier: Apache-2.0
// Makes completion scripts and the man page from the options of all commands. The facts of each option are collected
// once, and each shell has its own quoting and its own form of script.
#include "option_tables.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/version.h"

namespace meristem::cli {

namespace {

/// The kinds of values that a shell can complete.
enum class Values { none, files, documents, shells };

struct OptionFacts {
  std::vector<std::string> names;  // with their dashes, short names first; empty for a positional
  std::string type;                // type of its value; empty for a flag
  std::string doc;
  Values values = Values::none;
};

struct CommandFacts {
  std::string name;
  std::string doc;
  std::vector<OptionFacts> options;
  std::vector<OptionFacts> positionals;
  std::string footer;
};

Values values_of(std::string_view type) {
  if (type == "DOC") return Values::documents;
  if (type == "SHELL") return Values::shells;
  return type == "FILE" || type == "FILE ..." || type == "DIR" ? Values::files : Values::none;
}

OptionFacts facts_of(const CLI::Option& option) {
  OptionFacts facts;
  for (const std::string& name : option.get_snames()) facts.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) facts.names.push_back("--" + name);
  const bool takes_value = option.get_items_expected_max() > 0;
  if (takes_value) facts.type = option.get_type_name();
  // Checks add bounds to the name of a type: "N:INT in [1 - 1024]".
  facts.type = facts.type.substr(0, facts.type.find(':'));
  if (facts.names.empty() && facts.type.empty()) facts.type = option.get_name();
  facts.doc = option.get_description();
  facts.values = values_of(facts.type);
  return facts;
}

CommandFacts facts_of(const CLI::App& command) {
  CommandFacts facts{command.get_name(), command.get_description(), {}, {}, command.get_footer()};
  for (const CLI::Option* option : command.get_options()) {
    (option->get_positional() ? facts.positionals : facts.options).push_back(facts_of(*option));
  }
  return facts;
}

std::vector<CommandFacts> commands_of(const CLI::App& app) {
  std::vector<CommandFacts> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(facts_of(*command));
  }
  return commands;
}

std::string joined(const std::vector<OptionFacts>& options) {
  std::string text;
  for (const OptionFacts& option : options)
    text += fmt::format("{}{}", text.empty() ? "" : " ", fmt::join(option.names, " "));
  return text;
}

std::string names_of(const std::vector<CommandFacts>& commands) {
  std::string text;
  for (const CommandFacts& command : commands) text += (text.empty() ? "" : " ") + command.name;
  return text;
}

Values values_of_positional(const CommandFacts& command) {
  return command.positionals.empty() ? Values::none : command.positionals.front().values;
}

// --- bash

std::string_view bash_values(Values values) {
  switch (values) {
    case Values::files:
      return "compopt -o filenames; COMPREPLY=($(compgen -f -- \"$current\"))";
    case Values::documents:
      return "compopt -o filenames; COMPREPLY=($(compgen -W \"$(meristem models --names 2>/dev/null)\" -f -- "
             "\"$current\"))";
    case Values::shells:
      return "COMPREPLY=($(compgen -W 'bash zsh fish' -- \"$current\"))";
    case Values::none:
      break;
  }
  return ":";
}

std::string bash_script(const std::vector<CommandFacts>& commands) {
  std::string text = fmt::format(R"(# bash completion of meristem
_meristem() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}"
  COMPREPLY=()
  if [[ $COMP_CWORD -eq 1 ]]; then
    COMPREPLY=($(compgen -W "{} --help --version" -- "$current"))
    return
  fi
  case "${{COMP_WORDS[1]}}" in
)",
                                 names_of(commands));
  for (const CommandFacts& command : commands) {
    text += fmt::format("    {})\n      case \"$before\" in\n", command.name);
    for (const OptionFacts& option : command.options) {
      if (option.type.empty()) continue;
      text += fmt::format("        {}) {}; return ;;\n", fmt::join(option.names, "|"), bash_values(option.values));
    }
    text += fmt::format(
        "      esac\n      if [[ $current == -* ]]; then\n        COMPREPLY=($(compgen -W \"{}\" -- "
        "\"$current\"))\n      else\n        {}\n      fi\n      ;;\n",
        joined(command.options), bash_values(values_of_positional(command)));
  }
  return text + "  esac\n}\ncomplete -F _meristem meristem\n";
}

// --- zsh

/// Escapes a text for a specification of _arguments in single quotes.
std::string zsh_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\'') {
      escaped += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string_view zsh_values(Values values) {
  switch (values) {
    case Values::files:
      return "_files";
    case Values::documents:
      return "_meristem_documents";
    case Values::shells:
      return "(bash zsh fish)";
    case Values::none:
      break;
  }
  return " ";
}

std::string zsh_argument(const OptionFacts& option) {
  const std::string value =
      option.type.empty() ? "" : fmt::format(":{}:{}", zsh_text(option.type), zsh_values(option.values));
  if (option.names.empty()) return fmt::format("        '{}' \\\n", value);
  std::string text;
  for (const std::string& name : option.names) {
    text += fmt::format("        '*{}[{}]{}' \\\n", name, zsh_text(option.doc), value);
  }
  return text;
}

std::string zsh_script(const std::vector<CommandFacts>& commands) {
  std::string text = R"zsh(#compdef meristem
_meristem_documents() {
  compadd -- ${(f)"$(meristem models --names 2>/dev/null)"}
  _files
}
_meristem() {
  if (( CURRENT == 2 )); then
    local -a commands=(
)zsh";
  for (const CommandFacts& command : commands) {
    text += fmt::format("      '{}:{}'\n", command.name, zsh_text(command.doc));
  }
  text += R"zsh(    )
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
)zsh";
  for (const CommandFacts& command : commands) {
    text += fmt::format("    {})\n      _arguments -s \\\n", command.name);
    for (const OptionFacts& option : command.options) text += zsh_argument(option);
    for (const OptionFacts& option : command.positionals) text += zsh_argument(option);
    text += "        && return\n      ;;\n";
  }
  return text + "  esac\n}\n_meristem \"$@\"\n";
}

// --- fish

/// Escapes a text for single quotes.
std::string fish_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\'' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string_view fish_values(Values values) {
  switch (values) {
    case Values::files:
      return " -r -F";
    case Values::documents:
      return " -r -F -a '(meristem models --names 2>/dev/null)'";
    case Values::shells:
      return " -x -a 'bash zsh fish'";
    case Values::none:
      break;
  }
  return " -x";
}

std::string fish_script(const std::vector<CommandFacts>& commands) {
  std::string text = "# fish completion of meristem\ncomplete -c meristem -f\n";
  for (const CommandFacts& command : commands) {
    text += fmt::format("complete -c meristem -n __fish_use_subcommand -a {} -d '{}'\n", command.name,
                        fish_text(command.doc));
  }
  for (const CommandFacts& command : commands) {
    const std::string when = fmt::format("complete -c meristem -n '__fish_seen_subcommand_from {}'", command.name);
    const Values values = values_of_positional(command);
    if (values == Values::documents) text += when + " -F -a '(meristem models --names 2>/dev/null)'\n";
    if (values == Values::files) text += when + " -F\n";
    if (values == Values::shells) text += when + " -a 'bash zsh fish'\n";
    for (const OptionFacts& option : command.options) {
      text += when;
      for (const std::string& name : option.names) {
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      text += fmt::format("{} -d '{}'\n", option.type.empty() ? "" : fish_values(option.values), fish_text(option.doc));
    }
  }
  return text;
}

// --- man

/// Escapes a text for man. A line must not begin with a dot or a quote, which would be a macro. Backslashes and hyphens
/// are escaped.
std::string man_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const bool is_at_begin = escaped.empty() || escaped.back() == '\n';
    if (is_at_begin && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string man_option(const OptionFacts& option) {
  std::string head;
  for (const std::string& name : option.names) {
    head += fmt::format("{}\\fB{}\\fR", head.empty() ? "" : ", ", man_text(name));
  }
  if (!option.type.empty()) head += fmt::format("{}\\fI{}\\fR", head.empty() ? "" : " ", man_text(option.type));
  return fmt::format(".TP\n{}\n{}\n", head, man_text(option.doc));
}

}  // namespace

std::string completion_script(const CLI::App& app, const std::string& shell) {
  const std::vector<CommandFacts> commands = commands_of(app);
  if (shell == "bash") return bash_script(commands);
  return shell == "zsh" ? zsh_script(commands) : fish_script(commands);
}

std::string man_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH MERISTEM 1 \"\" \"meristem {}\" \"User Commands\"\n.SH NAME\nmeristem \\- grow plants from documents\n"
      ".SH SYNOPSIS\n.B meristem\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n{}\n.SH COMMANDS\n",
      version(), man_text(app.get_description()));
  for (const CommandFacts& command : commands_of(app)) {
    text += fmt::format(".SS \"meristem {}", command.name);
    for (const OptionFacts& positional : command.positionals) text += " " + man_text(positional.type);
    text += fmt::format("\"\n{}.\n", man_text(command.doc));
    for (const OptionFacts& positional : command.positionals) text += man_option(positional);
    for (const OptionFacts& option : command.options) text += man_option(option);
    if (!command.footer.empty()) text += fmt::format(".PP\n.nf\n{}\n.fi\n", man_text(command.footer));
  }
  return text +
         ".SH EXIT STATUS\n0 if all is done, 1 if a file, the disk or the memory failed, or if a data set is not as it "
         "was written, 2 if the command line or the document is wrong, 3 if a data set is complete but some of its "
         "plants "
         "have failed.\n";
}

}  // namespace meristem::cli
