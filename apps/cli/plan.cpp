// SPDX-License-Identifier: Apache-2.0
// The command `plan`: lists the operations that would be carried out on the trees of a document at their last
// iteration.
#include "meristem/document/plan.h"

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
#include "meristem/document/grow.h"
#include "meristem/document/json.h"
#include "meristem/document/locate.h"
#include "meristem/export/formats.h"
#include "meristem/export/output_files.h"
#include "meristem/output/skeleton/operation_csv.h"
#include "meristem/plant/plant_variant.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct PlanOptions {
  DocumentOptions document;
  std::string output;  // file of a table; empty: printed as text
  std::string before;
  std::string after;
  std::vector<std::string> rules;
};

constexpr const char* kRule = "--rule";  // name of the rules in messages

std::string told(const OperationRecord& record) {
  std::string text = fmt::format("{}: {} {}", record.operation, record.act, record.shoot);
  if (record.metamer > 0) text += fmt::format(" above metamer {}", record.metamer);
  text += fmt::format(" at ({:.3f}, {:.3f}, {:.3f}) m", record.position.x, record.position.y, record.position.z);
  if (record.metamers > 0) {
    text +=
        fmt::format(", {}, {:.3f} m, {:.1f} mm thick", counted(static_cast<std::uint64_t>(record.metamers), "metamer"),
                    record.length, 1000 * record.diameter);
  }
  return text;
}

void plan(const PlanOptions& options) {
  const auto format_at = [](const std::string& path) { return path.empty() ? nullptr : &format_of(path); };
  const FileFormat* const before = format_at(options.before);
  const FileFormat* const after = format_at(options.after);
  PlanRules rules{{}, kRule};
  for (const std::string& rule : options.rules) rules.operations.push_back(parse_json_of(rule, kRule));
  const Document asked = open_document(options.document);
  const Document done = read_again(asked, options.document, with_rules(asked, rules));
  const Document planned = read_again(asked, options.document, only_planned(asked, rules));
  for (const std::string& path : {options.output, options.before, options.after}) {
    if (!path.empty()) check_grown_output(asked, path);
  }

  const ThreadLimit threads = limited_threads(options.document.threads, options.document.quiet);
  std::vector<OperationRecord> records;
  {
    TerminalProgress terminal(options.document.quiet);
    Progress& progress = terminal.progress();
    FileSet files;
    GrowthCache cache;
    // One growth is shown before and after its plan. Both files' records are made in it.
    TraceRequest request = after != nullptr ? TraceRequest{TracePart::outcome} : TraceRequest{};
    for (const FileFormat* format : {before, after})
      request = request | (format != nullptr ? format->request : TraceRequest{});
    const auto grow = [&](const FileFormat* const& format, bool outcome) {
      const std::span<const FileFormat* const> formats(&format, format != nullptr ? 1 : 0);
      return grow_document(planned, progress,
                           {.up_to = needed_part(formats), .cache = &cache, .view = {{}, request, outcome}});
    };
    GrownDocument grown = grow(before, false);
    records = operation_records(*ExpandedPlant(grown.plant, planned.graph.limits, progress));
    if (!options.output.empty()) write_operation_csv(grown.plant, planned.graph.limits, options.output, progress);
    if (before != nullptr) before->write(planned, grown, options.before, {}, progress);
    if (after != nullptr) {
      grown = grow(after, true);
      after->write(done, grown, options.after, {}, progress);
    }
    files.commit();
  }
  if (options.output.empty()) {
    for (const OperationRecord& record : records) print_line(told(record));
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
