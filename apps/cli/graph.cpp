// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include <CLI/App.hpp>

#include "commands.h"
#include "documents.h"
#include "meristem/base/atomic_file.h"
#include "meristem/export/graph/graph_drawing.h"
#include "meristem/export/output_files.h"
#include "meristem/graph/instances.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

constexpr std::uint64_t kMaxInstances = 20'000;

struct GraphOptions {
  DocumentOptions document;
  bool tree = false;
  bool types = false;
  std::uint64_t max = 200;
  double time = 0;
  std::string output = "-";
};

void draw(const GraphOptions& options) {
  const Document document = open_document(options.document);
  check_output(options.output, document.source.named_files);
  const ThreadLimit threads = limited_threads(options.document.threads, options.document.quiet);
  std::string drawing;
  if (options.tree) {
    TerminalProgress terminal(options.document.quiet);
    const InstanceTree tree =
        instance_tree(document.graph, document.scene, options.time, options.max, terminal.progress());
    drawing = draw_instance_tree(document.graph, tree);
  } else {
    drawing = draw_graph(document.graph, {.shows_types = options.types});
  }
  AtomicFile file(options.output);
  file.write(drawing);
  file.commit();
}

}  // namespace

void add_graph(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("graph", "Draw the p-graph of a plant, or its i-tree, as SVG");
  auto options = std::make_shared<GraphOptions>();
  options->document.add_to(*command);
  command->add_flag("--tree", options->tree, "Draw the i-tree, the tree of all instances, instead");
  command->add_flag("--types", options->types, "Write the type of each component below its name");
  command
      ->add_option("--most", options->max,
                   "Greatest number of instances that --tree draws; larger trees end in an error; by default, 200")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, kMaxInstances));
  command->add_option("--time", options->time, "Time of the document at which --tree expands it; by default, 0")
      ->type_name("SECONDS");
  command->add_option("-o,--output", options->output, "File to write; by default, standard output")->type_name("FILE");
  command->footer("Example: meristem graph sunflower --types -o sunflower.svg");
  command->callback([options, &run] { run = [options] { draw(*options); }; });
}

}  // namespace meristem::cli
