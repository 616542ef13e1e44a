// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "frames.h"
#include "meristem/base/parallel.h"
#include "meristem/measure/counts.h"
#include "meristem/output/formats.h"
#include "meristem/output/output_files.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

struct GrowOptions {
  DocumentOptions document;
  std::vector<std::string> outputs;
  double time = 0;
  FormatOptions format;
};

/// An option that would change none of the files is a mistake.
void check_options(const GrowOptions& options, const std::vector<const Format*>& formats) {
  const auto can_instance = [](const Format* format) { return format->can_instance; };
  if (!options.format.instanced || std::any_of(formats.begin(), formats.end(), can_instance)) return;
  throw InputError(
      Diagnostic{.message = "--instanced changes none of the files", .expected = "a file that ends in .glb"});
}

void grow(const GrowOptions& options) {
  // Everything that can be wrong with the command line and the document comes before any work.
  std::vector<const Format*> formats;
  for (const std::string& output : options.outputs) formats.push_back(&format_of(output));
  const double time = checked_time(options.time);
  check_options(options, formats);
  const Document document = open_document(options.document);
  for (const std::string& output : options.outputs) check_grown_output(document, output);

  const ThreadLimit threads(options.document.threads);
  std::string summary;
  {
    TerminalProgress terminal(options.document.quiet);
    const GrownDocument grown = grow_document(document, terminal.progress(), time);
    for (std::size_t k = 0; k < formats.size(); ++k) {
      formats[k]->write(document, grown, options.outputs[k], options.format, terminal.progress());
    }
    const Counts counts = count(grown.plant, grown.meshes);
    summary = fmt::format("{}: {} nodes, {} organs, {} triangles, {:.2f} m high", fmt::join(options.outputs, ", "),
                          counts.nodes, counts.organs, counts.triangles, counts.height);
  }
  if (!options.document.quiet) print_status(summary);
}

}  // namespace

void add_grow(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("grow", "Grow a document and write it to files");
  auto options = std::make_shared<GrowOptions>();
  options->document.add_to(*command);
  command
      ->add_option("-o,--output", options->outputs,
                   "File to write, its format by its ending, see below; - for standard output; may be repeated")
      ->required()
      ->type_name("FILE")
      ->allow_extra_args(false);
  command->add_option("--time", options->time, "Grow the document as it stands at this time, its t, in seconds")
      ->type_name("T");
  command->add_flag("--instanced", options->format.instanced,
                    "Write leaves to .glb as places of one mesh: small files, that not every program reads");
  std::string endings;
  for (const Format& format : formats()) endings += fmt::format("  {:<14} {}\n", format.ending, format.doc);
  command->footer("Files end in:\n" + endings +
                  "Example: meristem grow models/oak.json -o oak.glb --seed 3 --set leaf.length=0.12");
  command->callback([options, &run] { run = [options] { grow(*options); }; });
}

}  // namespace meristem::cli
