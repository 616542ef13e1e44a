// SPDX-License-Identifier: Apache-2.0
// What people would do to the trees of a document now: the operations of their last iteration, found and not done.
#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "meristem/base/atomic_file.h"
#include "meristem/base/counted.h"
#include "meristem/base/parallel.h"
#include "meristem/components/expanded.h"
#include "meristem/document/grow.h"
#include "meristem/document/json.h"
#include "meristem/document/locate.h"
#include "meristem/output/formats.h"
#include "meristem/output/output_files.h"
#include "meristem/output/skeleton/operation_csv.h"
#include "meristem/plant/plant_variant.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct PlanOptions {
  DocumentOptions document;
  std::string output;  // a table; empty: told in words
  std::string before;
  std::string after;
  std::vector<std::string> rules;
};

constexpr const char* kRule = "--rule";  // what messages call it

/// The components that could have operations, and the iteration of the last.
std::vector<std::pair<std::string, int>> pruned_components(const Document& document) {
  std::vector<std::pair<std::string, int>> found;
  for (const Prototype& component : document.graph.components) {
    if (const std::optional<int> last = last_iteration(component)) found.emplace_back(component.id, *last);
  }
  if (!found.empty()) return found;
  throw InputError(Diagnostic{.message = fmt::format("'{}' has no trees that operations act on", document.source.file),
                              .expected = "a document with a component of type organize"});
}

/// The operations of a component in the document's text, and those that were asked for besides: at the last iteration,
/// unless they say when.
Value with_rules(const Document& document, const std::string& id, int last, const std::vector<std::string>& rules) {
  const Value text = parse_json(document.source.text);
  const Value* components = text.find("components");
  const Value* own = components != nullptr ? components->find(id) : nullptr;
  const Value* given = own != nullptr ? own->find("operations") : nullptr;
  Value::List operations = given != nullptr && given->list() != nullptr ? *given->list() : Value::List();
  for (const std::string& rule : rules) {
    Value operation = parse_json_of(rule, kRule);
    if (operation.object() == nullptr) {
      throw InputError(
          Diagnostic{.message = fmt::format("--rule cannot be {}", operation.description()),
                     .expected = R"(an operation, such as {"do": "cut", "shoots": "inward", "above": 0})"});
    }
    const auto has = [&](const char* key) { return operation.find(key) != nullptr; };
    if (const Value* season = operation.find("season"); season != nullptr && *season == Value("summer")) {
      throw InputError(Diagnostic{.message = "--rule acts after all growth of the last iteration, and not in summer",
                                  .expected = "an operation without 'season'"});
    }
    if (!has("at") && !has("from") && !has("every") && !has("to")) {
      operation.object()->insert(operation.object()->begin(), {"at", Value(last)});
    }
    operations.push_back(std::move(operation));
  }
  return operations;
}

std::string told(const OperationRecord& record) {
  std::string text = fmt::format("{}: {} {}", record.operation, record.act, record.shoot);
  if (record.metamer > 0) text += fmt::format(" above metamer {}", record.metamer);
  text += fmt::format(" at ({:.3f}, {:.3f}, {:.3f}) m", record.position.x, record.position.y, record.position.z);
  if (record.metamers > 0) {
    text +=
        fmt::format(", {}, {:.3f} m", counted(static_cast<std::uint64_t>(record.metamers), "metamer"), record.length);
  }
  return text;
}

void plan(const PlanOptions& options) {
  const auto format_at = [](const std::string& path) { return path.empty() ? nullptr : &format_of(path); };
  const Format* const before = format_at(options.before);
  const Format* const after = format_at(options.after);
  const Document asked = open_document(options.document);
  DocumentOptions quiet = options.document;
  quiet.quiet = true;
  for (const auto& [id, last] : pruned_components(asked)) {
    if (options.rules.empty()) continue;
    quiet.overrides.push_back(
        {fmt::format("components.{}.operations", id), with_rules(asked, id, last, options.rules), kRule});
  }
  const Document done = options.rules.empty() ? asked : open_document(quiet);
  for (const auto& [id, last] : pruned_components(asked))
    quiet.overrides.push_back({fmt::format("components.{}.plan", id), true, ""});
  const Document planned = open_document(quiet);
  for (const std::string& path : {options.output, options.before, options.after}) {
    if (!path.empty()) check_grown_output(asked, path);
  }

  const ThreadLimit threads = limited_threads(options.document.threads, options.document.quiet);
  std::vector<OperationRecord> records;
  {
    TerminalProgress terminal(options.document.quiet);
    Progress& progress = terminal.progress();
    FileSet files;
    const auto options_for = [](const Format* const& format) {
      const std::span<const Format* const> formats(&format, format != nullptr ? 1 : 0);
      return GrowthOptions{.up_to = needed_part(formats), .view = {{}, needed_wish(formats)}};
    };
    GrownDocument grown = grow_document(planned, progress, options_for(before));
    records = operation_records(*ExpandedPlant(grown.plant, progress));
    if (!options.output.empty()) write_operation_csv(grown.plant, options.output, progress);
    if (before != nullptr) before->write(planned, grown, options.before, {}, progress);
    if (after != nullptr) {
      grown = grow_document(done, progress, options_for(after));
      after->write(done, grown, options.after, {}, progress);
    }
    files.commit();
  }
  if (options.output.empty()) {
    for (const OperationRecord& record : records) fmt::print("{}\n", told(record));
  }
  if (options.document.quiet) return;
  print_status(records.empty() ? "nothing to do" : fmt::format("{} to do", records.size()));
}

}  // namespace

void add_plan(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "plan", "Tell what operations would do to the trees of a document now, in its last iteration, without doing it");
  auto options = std::make_shared<PlanOptions>();
  options->document.add_to(*command);
  command
      ->add_option("-o,--output", options->output,
                   "Table in CSV to write, a row for each cut, with its position, instead of sentences; - for standard "
                   "output")
      ->type_name("FILE");
  command
      ->add_option("--rule", options->rules,
                   "Plan this operation too, JSON as in a document; at the last iteration unless it says when; may be "
                   "repeated")
      ->type_name("JSON")
      ->allow_extra_args(false);
  command->add_option("--before", options->before, "File to write with the trees before what is planned")
      ->type_name("FILE");
  command->add_option("--after", options->after, "File to write with the trees after it")->type_name("FILE");
  command->footer(
      "Example: meristem plan pear-espalier -o cuts.csv --before before.csv --after after.csv\n"
      "         meristem plan apple-row --rule '{\"do\": \"cut\", \"shoots\": \"inward\", \"above\": 0}'");
  command->callback([options, &run] { run = [options] { plan(*options); }; });
}

}  // namespace meristem::cli
