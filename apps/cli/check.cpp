// SPDX-License-Identifier: Apache-2.0
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

struct CheckOptions {
  DocumentOptions document;
  bool is_quick = false;
  bool expands = false;
};

/// Returns the warnings that growing the document would give. The plant alone is sufficient; no meshes are made.
std::vector<Diagnostic> growth_warnings(const Document& document, bool quiet) {
  TerminalProgress terminal(quiet);
  return grow_document(document, terminal.progress(), {.up_to = GrownPart::plant}).warnings;
}

void check(const CheckOptions& options) {
  const Document document = open_document(options.document);
  const bool quiet = options.document.quiet;
  const ThreadLimit threads = limited_threads(options.document.threads, quiet);
  if (!options.is_quick) {
    const std::vector<Diagnostic> warnings = growth_warnings(document, quiet);
    if (!quiet) print_diagnostics(warnings);
  }
  if (options.expands) {
    for (const Prototype& component : document.graph.components) {
      const Value operations = expanded_training(component);
      if (operations.is_null()) continue;
      fmt::print("{}\n", write_json(Value(Value::Object{{component.id, Value::Object{{"operations", operations}}}})));
    }
  }
  if (quiet) return;
  print_line(fmt::format("{}: good, {} and {}", document.source.file,
                         counted(document.graph.components.size(), "component"),
                         counted(document.graph.links.size(), "link")));
}

}  // namespace

void add_check(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("check", "Report every fault of a document, and of growing it");
  auto options = std::make_shared<CheckOptions>();
  options->document.add_to(*command);
  command->add_flag("--quick", options->is_quick, "Only read the document; do not grow its plants");
  command->add_flag("--expand", options->expands,
                    "Print the operations that each training stands for, as a document would list them");
  command->footer("Example: meristem check models/oak.json");
  command->callback([options, &run] { run = [options] { check(*options); }; });
}

}  // namespace meristem::cli
