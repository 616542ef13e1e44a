// SPDX-License-Identifier: Apache-2.0
// The command `derive`: reads a grammar from a file or from a component of a document, derives its word, and prints or
// interprets it. A file with the key "meristem" is a document, any other file a grammar.
#include "meristem/grow/lsystem/derive.h"

#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "meristem/base/atomic_file.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/parallel.h"
#include "meristem/document/document.h"
#include "meristem/document/json.h"
#include "meristem/export/output_files.h"
#include "meristem/grow/lsystem/grammar_reader.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct DeriveOptions {
  std::string path;
  std::string root;
  std::optional<int> steps;
  std::optional<double> time;
  std::uint64_t seed = 1;
  std::vector<std::string> defines;
  bool drawn = false;
  bool stats = false;
  std::string output = "-";
  int threads = 0;
  bool quiet = false;

  std::string file() const { return path == "-" ? "<standard input>" : path; }
};

/// Parses "NAME=VALUE". The value is an expression without names.
ExpressionNames::Constant parse_define(const std::string& text) {
  const std::size_t equals = text.find('=');
  const auto fail = [&](const std::string& message) {
    throw InputError(Diagnostic{.message = message, .expected = "NAME=VALUE, such as angle=22.5"});
  };
  if (equals == std::string::npos || equals == 0) fail(fmt::format("--define {} defines nothing", in_quotes(text)));
  const std::string value = text.substr(equals + 1);
  try {
    const Expression expression = Expression::compile(value, {});
    if (expression.is_constant() && std::isfinite(expression.evaluate())) {
      return {text.substr(0, equals), expression.evaluate()};
    }
  } catch (const ExpressionError&) {  // the message is equal in both cases
  }
  fail(fmt::format("--define {}: {} is not a number", in_quotes(text.substr(0, equals)), in_quotes(value)));
  return {};
}

/// Returns true if the text has the key "meristem", as all documents do.
bool is_document(std::string_view text) {
  constexpr std::string_view kKey = "\"meristem\"";
  const std::size_t key = text.find(kKey);
  if (key == std::string_view::npos) return false;
  const std::size_t next = text.find_first_not_of(" \t\r\n", key + kKey.size());
  return next != std::string_view::npos && text[next] == ':';
}

/// Reads the grammar, and adds the files that it was read from to `inputs`.
Grammar read(const DeriveOptions& command, std::vector<std::string>& inputs) {
  GrammarOptions options;
  options.file = command.file();
  for (const std::string& define : command.defines) options.overrides.push_back(parse_define(define));
  inputs.push_back(command.path);
  options.read = [root = command.root, folder = std::filesystem::path(command.path).parent_path(),
                  read = read_beside(command.path, &inputs)](const std::string& name) {
    require_within(root, (folder / name).string());
    return read(name);
  };
  if (command.path != "-") require_within(command.root, command.path);
  std::vector<Diagnostic> warnings;
  options.warnings = &warnings;
  const std::string text = read_text_file(command.path);
  if (is_document(text)) {
    throw InputError(Diagnostic{.message = "this is a plant document",
                                .expected = "the text of a grammar; 'meristem grow' takes documents",
                                .file = options.file});
  }
  Grammar grammar = read_grammar(text, options);
  if (!command.quiet) print_diagnostics(warnings);
  return grammar;
}

/// Returns the number of steps. For a grammar whose rules have lifetimes, returns the time.
double steps_of(const DeriveOptions& command, const Grammar& grammar) {
  const auto fail = [&](std::string message, std::string expected) {
    throw InputError(
        Diagnostic{.message = std::move(message), .expected = std::move(expected), .file = command.file()});
  };
  if (grammar.is_timed) {
    if (command.steps) fail("the rules of the grammar have lives, so it counts no steps", "--time T");
    if (!command.time && !grammar.time) fail("the grammar does not give its time", "'#time T' in it, or --time T");
    return command.time ? *command.time : *grammar.time;
  }
  if (command.time) fail("no rule of the grammar has a life, so it knows no time", "--steps N");
  if (command.steps) return *command.steps;
  if (grammar.steps) return *grammar.steps;
  fail("the grammar does not give the number of steps", "'#steps N' in it, or --steps N");
  return 0;
}

std::string stats_text(const Word& word, const Grammar& grammar, double steps) {
  Value::Object counts;
  for (const auto& [symbol, count] : symbol_counts(word, grammar.alphabet)) {
    counts.emplace_back(symbol, static_cast<double>(count));
  }
  return write_json(Value(Value::Object{{grammar.is_timed ? "time" : "steps", steps},
                                        {"length", static_cast<double>(word.module_count())},
                                        {"counts", Value(std::move(counts))}}));
}

void derive(const DeriveOptions& command) {
  std::vector<std::string> inputs;
  const Grammar grammar = read(command, inputs);
  const double steps = steps_of(command, grammar);
  check_output(command.output, inputs);

  const ThreadLimit threads = limited_threads(command.threads, command.quiet);
  TerminalProgress terminal(command.quiet);
  Progress& progress = terminal.progress();
  const SizeLimits limits;
  const RandomKey key(command.seed);
  const Word word = command.drawn ? derive_drawn(grammar, steps, key, limits, progress)
                                  : meristem::derive(grammar, steps, key, limits, progress);

  AtomicFile file(command.output);
  if (command.stats) {
    file.write(stats_text(word, grammar, steps));
  } else {
    progress.begin("writing", word.module_count());
    write_word_text(word, grammar.alphabet, [&](std::string_view piece, std::size_t modules) {
      file.write(piece);
      progress.advance(modules);
    });
    file.write("\n");
  }
  file.commit();
}

}  // namespace

void add_derive(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("derive", "Derive the word of a grammar (an L-system)");
  auto options = std::make_shared<DeriveOptions>();
  command->add_option("grammar", options->path, "A grammar's text, or - for standard input")
      ->required()
      ->type_name("FILE");
  command->add_option("--steps", options->steps, "Number of steps to derive; by default, the grammar's #steps")
      ->type_name("N")
      ->check(CLI::Range(0, kMaxSteps));
  command
      ->add_option("--time", options->time,
                   "Time to which a grammar develops whose rules have lives; by default, the grammar's #time")
      ->type_name("T")
      ->check(CLI::Range(0.0, 1e6));
  command->add_option("--seed", options->seed, "Seed of the random draws; by default, 1")
      ->type_name("N")
      ->check(is_seed());
  command
      ->add_option("--define", options->defines,
                   "Set a name that the grammar defines with #define (angle=22.5, r=1/3); may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--drawn", options->drawn, "Apply the interpretation rules, as drawing does");
  command->add_flag("--stats", options->stats, "Write the word's length and counts of symbols as JSON instead");
  command->add_option("-o,--output", options->output, "File to write; by default, standard output")->type_name("FILE");
  add_root_option(*command, options->root);
  add_run_options(*command, options->threads, options->quiet);
  command->footer("Example: meristem derive bush.txt --steps 4 --define angle=22.5 -o bush-word.txt");
  command->callback([options, &run] { run = [options] { derive(*options); }; });
}

}  // namespace meristem::cli
