// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "meristem/base/counted.h"
#include "meristem/base/parallel.h"
#include "meristem/components/expanded.h"
#include "meristem/document/grow.h"
#include "meristem/document/json.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

constexpr std::array kShares{0.0, 1.0, 0.5};  // of a variable's range; values in between are likely good if these are

struct CheckOptions {
  DocumentOptions document;
  bool is_quick = false;
  bool grows_ranges = false;
  bool expands = false;
};

/// Returns the warnings that growing the document would give. The plant alone is sufficient; no meshes are made.
std::vector<Diagnostic> growth_warnings(const Document& document, bool quiet) {
  TerminalProgress terminal(quiet);
  return grow_document(document, terminal.progress(), {.up_to = GrownPart::plant}).warnings;
}

/// Returns the errors of the document if the variable has this value. Grows its plants if `grows` is true.
std::vector<Diagnostic> errors_at(const Document& document, const DocumentOptions& options, const Variable& variable,
                                  double value, bool grows) {
  try {
    const Document other = read_again(document, options, {{.path = variable.name, .value = value, .name = {}}});
    if (grows) growth_warnings(other, true);
  } catch (const InputError& error) {
    std::vector<Diagnostic> errors = error.diagnostics();
    std::erase_if(errors, [](const Diagnostic& each) { return each.severity != Severity::error; });
    return errors;
  }
  return {};
}

/// Returns true if the document gives both ends of the variable's range, and the variable is a handle for users.
bool has_range(const Document& document, const Variable& variable) {
  if (variable.is_private || !variable.per.empty() || !(variable.min < variable.max)) return false;
  const Value* written = document.source.tree.find("variables")->find(variable.name);
  return written != nullptr && written->find("min") != nullptr && written->find("max") != nullptr;
}

/// Returns a warning for each variable with a value in its range that makes the document faulty.
std::vector<Diagnostic> warnings_of_ranges(const Document& document, const CheckOptions& options) {
  std::vector<Diagnostic> warnings;
  for (const Variable& variable : document.variables) {
    if (!has_range(document, variable)) continue;
    for (const double share : kShares) {
      const double value = variable.min + share * (variable.max - variable.min);
      if (value == variable.value) continue;
      std::vector<Diagnostic> errors = errors_at(document, options.document, variable, value, options.grows_ranges);
      if (errors.empty()) continue;
      Diagnostic warning = std::move(errors.front());
      warning.severity = Severity::warning;
      const std::string others =
          errors.size() > 1 ? fmt::format(", and {}", counted(errors.size() - 1, "more fault")) : std::string();
      warning.message =
          fmt::format("if {} is {:.7g}, which its range allows, {}{}", variable.name, value, warning.message, others);
      warnings.push_back(std::move(warning));
      break;
    }
  }
  return warnings;
}

/// Returns the number of components and links, without the camera that a document without a camera gets.
std::string size_of(const Document& document) {
  const Graph& graph = document.graph;
  const std::string& root = graph.components[graph.structure.root].id;
  const Value* written = document.source.tree.find("components");
  const bool is_hidden = written->find(root) == nullptr;
  const std::size_t links = is_hidden ? graph.structure.outgoing[graph.structure.root].size() : 0;
  return fmt::format("{} and {}", counted(graph.components.size() - (is_hidden ? 1 : 0), "component"),
                     counted(graph.links.size() - links, "link"));
}

void check(const CheckOptions& options) {
  const Document document = open_document(options.document);
  const bool quiet = options.document.quiet;
  const ThreadLimit threads = limited_threads(options.document.threads, quiet);
  if (!options.is_quick) {
    const std::vector<Diagnostic> warnings = growth_warnings(document, quiet);
    if (!quiet) print_diagnostics(warnings);
  }
  if (!quiet) print_diagnostics(warnings_of_ranges(document, options));
  if (options.expands) {
    for (const Prototype& component : document.graph.components) {
      const Value operations = expanded_training(component);
      if (operations.is_null()) continue;
      fmt::print("{}\n", write_json(Value(Value::Object{{component.id, Value::Object{{"operations", operations}}}})));
    }
  }
  if (quiet) return;
  print_line(fmt::format("{}: good, {}", document.source.file, size_of(document)));
}

}  // namespace

void add_check(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("check", "Report every fault of a document, and of growing it");
  auto options = std::make_shared<CheckOptions>();
  options->document.add_to(*command);
  command->add_flag("--quick", options->is_quick, "Only read the document; do not grow its plants");
  command
      ->add_flag("--ranges", options->grows_ranges,
                 "Also grow it with each variable at its least, middle and greatest value")
      ->excludes("--quick");
  command->add_flag("--expand", options->expands,
                    "Print the operations that each training stands for, as a document would list them");
  command->footer("Example: meristem check models/oak.json");
  command->callback([options, &run] { run = [options] { check(*options); }; });
}

}  // namespace meristem::cli
