// SPDX-License-Identifier: Apache-2.0
// Reads grammars in two passes: names and symbols first, then directives, axiom and rules. All errors are collected.
#include "meristem/grow/lsystem/grammar_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "meristem/base/in_quotes.h"
#include "meristem/base/read_file.h"
#include "meristem/grow/lsystem/grammar_check.h"
#include "meristem/grow/lsystem/grammar_include.h"
#include "meristem/grow/lsystem/grammar_parts.h"
#include "meristem/grow/lsystem/grammar_text.h"
#include "meristem/grow/lsystem/module_reader.h"
#include "meristem/grow/lsystem/rule_reader.h"

namespace meristem {

namespace {

constexpr std::size_t kDeepestInclusion = 16;
constexpr int kMaxInclusions = 100;
constexpr std::size_t kLongestName = 64;

/// State shared by the readers of a grammar and of the grammars that it includes.
struct Inclusions {
  std::vector<std::string> files;  ///< chain of files from the first to the current one
  int count = 0;
};

struct Directive {
  std::string_view all;
  std::string_view name;
  std::string_view rest;  ///< trimmed
};

const std::vector<std::string>& directive_names() {
  static const std::vector<std::string> kNames = {"#axiom", "#rules", "#decompose", "#interpret", "#define", "#ignore",
                                                  "#steps", "#time",  "#angle",     "#symbols",   "#include"};
  return kNames;
}

bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Parses a directive: # and a letter. A # before any other character is a symbol.
std::optional<Directive> as_directive(std::string_view line) {
  if (line.size() < 2 || line[0] != '#' || !is_ascii_letter(line[1])) return std::nullopt;
  std::size_t end = 1;
  while (end < line.size() && is_ascii_letter(line[end])) ++end;
  return Directive{line, line.substr(0, end), trimmed(line.substr(end))};
}

/// Removes the next word from `rest` and returns it. Quoted words may contain blanks.
std::string_view take_word(std::string_view& rest) {
  rest = trimmed(rest);
  const bool is_quoted = rest.starts_with('"') && rest.find('"', 1) != std::string_view::npos;
  if (is_quoted) {
    const std::size_t end = rest.find('"', 1);
    const std::string_view word = rest.substr(1, end - 1);
    rest.remove_prefix(end + 1);
    return word;
  }
  const auto end = static_cast<std::size_t>(std::find_if(rest.begin(), rest.end(), is_blank) - rest.begin());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end);
  return word;
}

/// Returns the part of the kit that the directive includes: its name after kPartsFolder. Returns nothing for grammars
/// in files, which stand for a symbol.
std::optional<std::string_view> part_name(const Directive& directive) {
  std::string_view rest = directive.rest;
  const std::string_view file = take_word(rest);
  if (directive.name != "#include" || !file.starts_with(kPartsFolder) || !trimmed(rest).empty()) return std::nullopt;
  return file.substr(kPartsFolder.size());
}

/// Returns the text with the texts of all included parts behind it, each once.
std::string with_parts(std::string_view text, const GrammarOptions& options) {
  std::string all(text);
  if (text.find("#include") == std::string_view::npos) return all;
  std::vector<const GrammarPart*> parts;
  const GrammarText grammar(text, options.file, options.limits);
  for (const std::string_view line : grammar.lines()) {
    const auto directive = as_directive(line);
    const auto name = directive ? part_name(*directive) : std::nullopt;
    const GrammarPart* part = name ? find_grammar_part(*name) : nullptr;
    if (part == nullptr || std::ranges::find(parts, part) != parts.end()) continue;
    parts.push_back(part);
    // A \ at the end of the text joins the blank line, not the part.
    all.append("\n\n").append(part->text);
  }
  return all;
}

class GrammarReader {
 public:
  GrammarReader(std::string_view text, const GrammarOptions& options, Inclusions& inclusions)
      : options_(options),
        inclusions_(inclusions),
        own_bytes_(text.size()),
        text_(with_parts(text, options), options.file, options.limits),
        errors_(text_, std::max<std::size_t>(1, options.limits.diagnostics)),
        modules_(errors_, grammar_.alphabet),
        rules_(text_, errors_, options.limits, modules_, options.constants) {
    if (options.words == nullptr) return;
    modules_.note_symbols(&symbols_);
    rules_.note_names(&names_);
  }

  Grammar read();

 private:
  enum class Section { preamble, axiom, production, decomposition, interpretation };

  void read_names(const std::vector<std::string_view>& lines);
  void read_define(const Directive& directive);
  double overridden(const std::string& name, double value) const;
  void check_overrides(std::string_view place);
  void read_symbols(const Directive& directive);

  void read_directive(const Directive& directive);
  void read_line(std::string_view line);
  void read_ignore(const Directive& directive);
  void read_steps(const Directive& directive);
  void read_time(const Directive& directive);
  void check_lives();
  void read_angle(const Directive& directive);
  void read_include(const Directive& directive);
  std::optional<std::string> included_text(const Directive& directive, const std::string& written,
                                           const std::string& name);
  bool include(const Directive& directive, std::string_view file, LetterIndex letter, std::string_view steps);
  void check_part(const Directive& directive, std::string_view name);
  void read_parts(std::span<const std::string_view> lines);
  std::optional<int> step_count(std::string_view text);
  void add_rule(GrammarRule rule, std::string_view place, RuleSet& set, std::vector<std::string_view>& places);

  void finish();
  std::vector<GrammarWord> words_of(std::vector<std::string_view> pieces) const;
  void drop_identities(RuleSet& set, std::vector<std::string_view>& places) const;
  bool is_identity(const GrammarRule& rule) const;

  const GrammarOptions& options_;
  Inclusions& inclusions_;
  std::size_t own_bytes_;  ///< bytes of the grammar itself; the parts of the kit follow
  GrammarText text_;
  GrammarErrors errors_;
  Grammar grammar_;
  ModuleReader modules_;
  RuleReader rules_;
  RuleTexts places_;
  Section section_ = Section::preamble;
  std::vector<std::string_view> open_brackets_;  ///< unclosed brackets of the axiom
  std::vector<std::string_view> ignored_;
  std::vector<std::string> defined_;  ///< names of constants
  std::vector<std::string_view> symbols_;
  std::vector<std::string_view> names_;
  std::string_view axiom_place_;
  std::string_view steps_place_;
  std::string_view time_place_;
};

Grammar GrammarReader::read() {
  grammar_.open = grammar_.alphabet.add("[", 0);
  grammar_.close = grammar_.alphabet.add("]", 0);
  grammar_.cut = grammar_.alphabet.add("%", 0);
  const std::vector<std::string_view> lines = text_.lines();
  const auto parts = std::ranges::find_if(lines, [&](auto line) { return text_.offset(line) >= own_bytes_; });
  read_names(lines);
  for (const std::string_view line : std::span(lines.begin(), parts)) {
    if (errors_.is_full()) break;
    if (const auto directive = as_directive(line)) {
      read_directive(*directive);
    } else {
      read_line(line);
    }
  }
  read_parts(std::span(parts, lines.end()));
  if (options_.words != nullptr) *options_.words = {words_of(symbols_), words_of(names_)};
  finish();
  return std::move(grammar_);
}

std::vector<GrammarWord> GrammarReader::words_of(std::vector<std::string_view> pieces) const {
  std::sort(pieces.begin(), pieces.end(), [](auto a, auto b) { return a.data() < b.data(); });
  std::vector<GrammarWord> words;
  for (const std::string_view piece : pieces) {
    GrammarWord word{text_.offset(piece), std::string(piece)};
    if (word.offset >= own_bytes_) break;  // the parts of the kit are not in the text
    if (words.empty() || words.back() != word) words.push_back(std::move(word));
  }
  return words;
}

// Names are read first, so that symbols may be declared after their use.

void GrammarReader::read_names(const std::vector<std::string_view>& lines) {
  for (const std::string_view line : lines) {
    if (errors_.is_full()) return;
    const auto directive = as_directive(line);
    if (!directive) continue;
    if (directive->name == "#define") read_define(*directive);
    if (directive->name == "#symbols") read_symbols(*directive);
  }
  if (!lines.empty()) check_overrides(lines.front());
}

void GrammarReader::read_define(const Directive& directive) {
  std::string_view value = directive.rest;
  std::size_t end = 0;
  while (end < value.size() && !is_blank(value[end]) && value[end] != '=') ++end;
  const std::string_view name = value.substr(0, end);
  value = trimmed(value.substr(end));
  if (value.starts_with('=')) value = trimmed(value.substr(1));
  defined_.emplace_back(name);
  if (options_.words != nullptr) names_.push_back(name);
  if (name.empty() || value.empty()) {
    errors_.add(directive.all, "'#define' lacks a name or a value", "#define name = expression");
  } else if (!is_identifier(name)) {
    errors_.add(name, fmt::format("{} is not a name", in_quotes(name)), "letters, digits and _, no digit first");
  } else if (is_builtin_name(name)) {
    errors_.add(name, fmt::format("'{}' is a function or constant of every expression", name), "another name");
  } else if (const auto number = rules_.read_constant(value)) {
    rules_.constants().set(defined_.back(), overridden(defined_.back(), *number));
  }
}

double GrammarReader::overridden(const std::string& name, double value) const {
  for (const auto* constants : {&options_.constants, &options_.overrides}) {
    for (const auto& constant : *constants) {
      if (constant.name == name) value = constant.value;
    }
  }
  return value;
}

void GrammarReader::check_overrides(std::string_view place) {
  constexpr std::size_t kMaxNames = 12;  // names in a message
  const std::vector<std::string> names(
      defined_.begin(), defined_.begin() + static_cast<std::ptrdiff_t>(std::min(defined_.size(), kMaxNames)));
  for (const auto& constant : options_.overrides) {
    if (std::find(defined_.begin(), defined_.end(), constant.name) != defined_.end()) continue;
    Diagnostic error;
    error.message = fmt::format("the grammar does not define {}", in_quotes(constant.name));
    error.expected = names.empty() ? "a grammar with #define lines"
                                   : fmt::format("a name that it defines: {}{}", fmt::join(names, ", "),
                                                 names.size() < defined_.size() ? ", ..." : "");
    error.nearest = nearest_name(constant.name, defined_);
    error.file = options_.file;
    errors_.add_all(place, {error});
  }
}

void GrammarReader::read_symbols(const Directive& directive) {
  std::string_view rest = directive.rest;
  if (rest.empty()) errors_.add(directive.all, "'#symbols' declares no symbols", "names of two characters or more");
  while (!rest.empty() && !errors_.is_full()) {
    const std::string_view name = take_word(rest);
    rest = trimmed(rest);
    if (!is_identifier(name) || name.size() < 2 || name.size() > kLongestName) {
      errors_.add(name, fmt::format("{} cannot be declared", in_quotes(name)),
                  fmt::format("a name of 2 to {} letters, digits and _, no digit first", kLongestName));
    } else {
      modules_.declare(name);
    }
  }
}

// Reads the lines in order.

void GrammarReader::read_directive(const Directive& directive) {
  const auto begin = [&](Section section) {
    section_ = section;
    if (!directive.rest.empty()) read_line(directive.rest);
  };
  const std::string_view name = directive.name;
  if (name == "#axiom") {
    if (!axiom_place_.empty()) {
      errors_.add(directive.all, fmt::format("a second axiom; the first is in line {}", text_.line(axiom_place_)),
                  "one axiom");
      return;
    }
    axiom_place_ = directive.all;
    begin(Section::axiom);
  } else if (name == "#rules") {
    begin(Section::production);
  } else if (name == "#decompose") {
    begin(Section::decomposition);
  } else if (name == "#interpret") {
    begin(Section::interpretation);
  } else if (name == "#ignore") {
    read_ignore(directive);
  } else if (name == "#steps") {
    read_steps(directive);
  } else if (name == "#time") {
    read_time(directive);
  } else if (name == "#angle") {
    read_angle(directive);
  } else if (name == "#include") {
    read_include(directive);
  } else if (name != "#define" && name != "#symbols") {
    errors_.add(directive.all, fmt::format("{} is not a directive", in_quotes(name)), "a directive such as #rules",
                nearest_name(name, directive_names()));
  }
}

void GrammarReader::read_line(std::string_view line) {
  const bool is_before_rules = section_ == Section::preamble || section_ == Section::axiom;
  if (is_before_rules && find_arrow(line)) section_ = Section::production;
  switch (section_) {
    case Section::preamble:
    case Section::axiom:
      if (axiom_place_.empty()) axiom_place_ = line;
      rules_.read_axiom(line, open_brackets_, grammar_.axiom);
      return;
    case Section::production:
      if (auto rule = rules_.read_rule(line, RuleReader::Kind::production)) {
        add_rule(std::move(*rule), line, grammar_.production, places_.production);
      }
      return;
    case Section::decomposition:
      if (auto rule = rules_.read_rule(line, RuleReader::Kind::decomposition)) {
        add_rule(std::move(*rule), line, grammar_.decomposition, places_.decomposition);
      }
      return;
    case Section::interpretation:
      if (auto rule = rules_.read_rule(line, RuleReader::Kind::interpretation)) {
        add_rule(std::move(*rule), line, grammar_.interpretation, places_.interpretation);
      }
      return;
  }
}

void GrammarReader::add_rule(GrammarRule rule, std::string_view place, RuleSet& set,
                             std::vector<std::string_view>& places) {
  set.rules.push_back(std::move(rule));
  places.push_back(place);
}

void GrammarReader::read_ignore(const Directive& directive) {
  std::string_view rest = directive.rest;
  if (rest.starts_with(':')) rest.remove_prefix(1);
  while (const auto module = modules_.next(rest)) {
    if (errors_.is_full()) return;
    if (module->symbol == "[" || module->symbol == "]") {
      errors_.add(module->all, "contexts cannot ignore brackets", "other symbols");
    } else if (!module->arguments.empty()) {
      errors_.add(module->all, fmt::format("{} has parameters", in_quotes(module->all)),
                  "a symbol alone; it is ignored with any number of parameters");
    } else {
      ignored_.push_back(module->symbol);
    }
  }
}

std::optional<int> GrammarReader::step_count(std::string_view text) {
  const auto steps = rules_.read_constant(text);
  if (!steps) return std::nullopt;
  if (*steps >= 0 && *steps <= kMaxSteps && std::floor(*steps) == *steps) return static_cast<int>(*steps);
  errors_.add(text, fmt::format("{} is not a number of steps", in_quotes(text)),
              fmt::format("a whole number from 0 to {}", kMaxSteps));
  return std::nullopt;
}

void GrammarReader::read_steps(const Directive& directive) {
  steps_place_ = directive.all;
  if (const auto steps = step_count(directive.rest)) grammar_.steps = steps;
}

void GrammarReader::read_time(const Directive& directive) {
  const auto time = rules_.read_constant(directive.rest);
  if (!time) return;
  if (*time >= 0) {
    grammar_.time = time;
    time_place_ = directive.all;
  } else {
    errors_.add(directive.rest, fmt::format("{} is not a time", in_quotes(directive.rest)), "a number of at least 0");
  }
}

void GrammarReader::read_angle(const Directive& directive) {
  if (const auto angle = rules_.read_constant(directive.rest)) grammar_.angle = angle;
}

void GrammarReader::check_part(const Directive& directive, std::string_view name) {
  if (find_grammar_part(name) != nullptr) return;
  std::vector<std::string> names;
  for (const GrammarPart& part : grammar_parts()) names.push_back(std::string(kPartsFolder).append(part.name));
  const std::string written = std::string(kPartsFolder).append(name);
  errors_.add(directive.all, fmt::format("{} is not among the parts of grammars", in_quotes(written)),
              fmt::format("one of {}", fmt::join(names, ", ")), nearest_name(written, names));
}

/// Reads the rules of the included parts. A part has no rules for letters that already have some.
void GrammarReader::read_parts(std::span<const std::string_view> lines) {
  std::vector<LetterIndex> taken;
  for (const std::string_view line : lines) {
    if (as_directive(line)) {  // #symbols, the first line of each part
      taken.clear();
      for (const GrammarRule& rule : grammar_.interpretation.rules) taken.push_back(rule.predecessor);
      continue;
    }
    auto rule = rules_.read_rule(line, RuleReader::Kind::interpretation);
    if (!rule || std::ranges::find(taken, rule->predecessor) != taken.end()) continue;
    add_rule(std::move(*rule), {}, grammar_.interpretation, places_.interpretation);
  }
}

void GrammarReader::read_include(const Directive& directive) {
  if (const auto part = part_name(directive)) return check_part(directive, *part);
  std::string_view rest = directive.rest;
  const std::string_view file = take_word(rest);
  const std::string_view as = take_word(rest);
  std::string_view symbol = take_word(rest);
  std::string_view steps;
  bool is_good = !file.empty() && as == "as" && !symbol.empty();
  const std::string_view duration = trimmed(rest);
  if (is_good && !duration.empty()) {
    const bool is_for = take_word(rest) == "for";
    steps = take_word(rest);
    const std::string_view unit = take_word(rest);
    is_good = is_for && (unit == "steps" || unit == "step") && trimmed(rest).empty();
  }
  if (!is_good) {
    errors_.add(directive.all, fmt::format("{} cannot be read", in_quotes(directive.all)),
                "#include file as X for n steps");
    return;
  }
  const auto module = modules_.next(symbol);
  if (!module) return;
  if (!trimmed(symbol).empty() || !module->arguments.empty() || module->symbol == "[" || module->symbol == "]") {
    errors_.add(module->all, fmt::format("{} cannot stand for a grammar", in_quotes(module->all)),
                "a symbol without parameters");
    return;
  }
  const LetterIndex letter = modules_.letter_of(*module);
  if (letter != kNoLetter) include(directive, file, letter, steps);
}

/// Returns the text of the included file `name`. Error messages use `written`, the name in this grammar.
std::optional<std::string> GrammarReader::included_text(const Directive& directive, const std::string& written,
                                                        const std::string& name) {
  try {
    return options_.read(name);
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) {
      // Convert the suggestion to a path relative to this grammar.
      const std::filesystem::path nearest = std::filesystem::path(found.nearest).filename();
      errors_.add(directive.all, fmt::format("{}: {}", in_quotes(written), found.message), found.expected,
                  nearest.empty() ? "" : (std::filesystem::path(written).parent_path() / nearest).string());
    }
    return std::nullopt;
  }
}

bool GrammarReader::include(const Directive& directive, std::string_view file, LetterIndex letter,
                            std::string_view steps) {
  const auto fail = [&](std::string message, std::string expected) {
    errors_.add(directive.all, std::move(message), std::move(expected));
    return false;
  };
  auto& files = inclusions_.files;
  // Paths are relative to the folder of this grammar, but `read` starts in the folder of the first grammar.
  const auto folder = files.size() > 1 ? std::filesystem::path(files.back()).parent_path() : std::filesystem::path();
  const std::string name = (folder / file).lexically_normal().string();
  if (!options_.read) return fail("this grammar cannot include others", "a grammar that is read from a file");
  if (std::find(files.begin(), files.end(), name) != files.end()) {
    return fail(fmt::format("{} includes itself", in_quotes(name)), "inclusions without a circle");
  }
  if (files.size() > kDeepestInclusion || ++inclusions_.count > kMaxInclusions) {
    return fail("too many grammars are included",
                fmt::format("at most {}, and {} inside each other", kMaxInclusions, kDeepestInclusion));
  }

  const std::optional<std::string> text = included_text(directive, std::string(file), name);
  if (!text) return false;
  GrammarOptions options = options_;
  options.file = name;
  options.words = nullptr;
  options.overrides.clear();
  files.push_back(name);
  try {
    const Grammar included = GrammarReader(*text, options, inclusions_).read();
    const std::optional<int> given = steps.empty() ? std::nullopt : step_count(steps);
    files.pop_back();
    if (!steps.empty() && !given) return false;
    const bool has_own = included.is_timed ? included.time.has_value() : included.steps.has_value();
    if (!given && !has_own) {
      return fail(fmt::format("{} has no {}", in_quotes(name), included.is_timed ? "#time" : "#steps"),
                  "#include file as X for n steps");
    }
    const double own = included.is_timed ? included.time.value_or(0) : included.steps.value_or(0);
    const double count = given ? *given : own;
    GrammarRule rule;
    rule.text = directive.all;
    rule.line = text_.line(directive.all);
    rule.predecessor = letter;
    rule.successor = included_word(included, count, options_.limits, grammar_.alphabet);
    const bool holds_itself = std::any_of(rule.successor.begin(), rule.successor.end(),
                                          [&](const ModuleTemplate& module) { return module.letter == letter; });
    if (holds_itself) {
      return fail(fmt::format("the word of {} has the letter that stands for it", in_quotes(name)), "another letter");
    }
    add_rule(std::move(rule), directive.all, grammar_.interpretation, places_.interpretation);
    return true;
  } catch (const InputError& error) {
    if (files.back() == name) files.pop_back();
    errors_.add_all(directive.all, error.diagnostics());
    return false;
  } catch (const std::length_error&) {
    return fail("the grammar has more than 65534 letters", "fewer");
  }
}

// Checks of the whole grammar.

bool GrammarReader::is_identity(const GrammarRule& rule) const {
  if (rule.condition || rule.life || rule.weight || !rule.left.empty() || !rule.right.empty()) return false;
  if (rule.successor.size() != 1 || rule.successor.front().letter != rule.predecessor) return false;
  const auto& parameters = rule.successor.front().parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    // An expression that consists of one name and uses this variable is the variable itself.
    if (!parameters[k].uses(rule.first_variable + k) || !is_identifier(parameters[k].text())) return false;
  }
  return true;
}

void GrammarReader::drop_identities(RuleSet& set, std::vector<std::string_view>& places) const {
  std::vector<std::uint32_t> count(grammar_.alphabet.size());
  for (const GrammarRule& rule : set.rules) ++count[rule.predecessor];
  std::size_t kept = 0;
  for (std::size_t k = 0; k < set.rules.size(); ++k) {
    if (count[set.rules[k].predecessor] == 1 && is_identity(set.rules[k])) continue;
    if (kept != k) set.rules[kept] = std::move(set.rules[k]);
    places[kept++] = places[k];
  }
  set.rules.resize(kept);
  places.resize(kept);
  set.of_letter.resize(grammar_.alphabet.size());
  for (std::size_t k = 0; k < kept; ++k) {
    set.of_letter[set.rules[k].predecessor].push_back(static_cast<std::uint32_t>(k));
  }
}

/// Checks that all rules of a timed grammar have lives, and that nothing depends on steps or random numbers.
void GrammarReader::check_lives() {
  const auto has_life = [](const GrammarRule& rule) { return rule.life.has_value(); };
  grammar_.is_timed = std::ranges::any_of(grammar_.production.rules, has_life);
  grammar_.asks_ages = std::ranges::any_of(grammar_.interpretation.rules, &GrammarRule::sees_age);
  if (!grammar_.is_timed) {
    if (grammar_.time) errors_.add(time_place_, "'#time' in a grammar without lives", "#steps, or rules with lives");
    return;
  }
  if (grammar_.steps) errors_.add(steps_place_, "'#steps' in a grammar with lives", "#time");
  const auto is_drawn = [](const std::optional<Expression>& expression) {
    return expression && expression->is_random();
  };
  for (std::size_t k = 0; k < grammar_.production.rules.size(); ++k) {
    const GrammarRule& rule = grammar_.production.rules[k];
    const std::string_view place = places_.production[k];
    bool is_random = is_drawn(rule.life) || is_drawn(rule.condition);
    for (const ModuleTemplate& form : rule.successor) {
      is_random = is_random || std::ranges::any_of(form.parameters, &Expression::is_random);
    }
    if (!has_life(rule)) {
      errors_.add(place, "the rule has no life, and others have one", "predecessor @ life -> successor");
    } else if (is_random) {
      errors_.add(place, "a rule with a life draws random numbers", "expressions without chance");
    }
  }
  if (!places_.decomposition.empty()) {
    errors_.add(places_.decomposition.front(), "a decomposition in a grammar with lives",
                "rules behind #rules, with lives, or behind #interpret");
  }
}

void GrammarReader::finish() {
  modules_.report_unclosed(open_brackets_);
  if (errors_.is_empty() && grammar_.axiom.empty()) {
    throw InputError(text_.error(axiom_place_.empty() ? 0 : text_.offset(axiom_place_), "the grammar has no axiom",
                                 "'#axiom' and a word"));
  }
  check_lives();
  if (!errors_.is_empty()) throw InputError(errors_.take_errors());

  grammar_.file = options_.file;
  drop_identities(grammar_.production, places_.production);
  drop_identities(grammar_.decomposition, places_.decomposition);
  drop_identities(grammar_.interpretation, places_.interpretation);
  grammar_.is_ignored.resize(grammar_.alphabet.size());
  const std::unordered_set<std::string_view> ignored(ignored_.begin(), ignored_.end());
  for (std::size_t k = 0; k < grammar_.alphabet.size(); ++k) {
    grammar_.is_ignored[k] = ignored.count(grammar_.alphabet[static_cast<LetterIndex>(k)].symbol) > 0 ? 1 : 0;
  }
  if (options_.warnings == nullptr) return;
  warn_of_idle_rules(grammar_, places_, errors_);
  for (Diagnostic& warning : errors_.take_warnings()) options_.warnings->push_back(std::move(warning));
}

}  // namespace

Grammar read_grammar(std::string_view text, const GrammarOptions& options) {
  Inclusions inclusions;
  inclusions.files.push_back(options.file);
  return GrammarReader(text, options, inclusions).read();
}

std::function<std::string(const std::string&)> read_beside(const std::string& file, std::vector<std::string>* paths) {
  return [paths, folder = std::filesystem::path(file).parent_path()](const std::string& name) {
    const std::string path = (folder / name).string();
    if (paths != nullptr) paths->push_back(path);
    return read_file(path, SizeLimits().document_bytes);
  };
}

}  // namespace meristem
