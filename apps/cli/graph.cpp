// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.h"
#include "documents.h"
#include "meristem/base/atomic_file.h"
#include "meristem/base/counted.h"
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
  std::string affects;
  std::uint64_t max = 200;
  double time = 0;
  std::string output = "-";
};

/// Returns a line such as "leaf.length affects 3 of 6 components: leaf; through it bud, petal".
std::string text_of_effects(const Document& document, const std::string& path,
                            const std::vector<GraphEffect>& effects) {
  std::vector<std::string> own, inherited;
  for (std::size_t c = 0; c < effects.size(); ++c) {
    if (effects[c] == GraphEffect::own) own.push_back(document.graph.components[c].id);
    if (effects[c] == GraphEffect::inherited) inherited.push_back(document.graph.components[c].id);
  }
  std::string text =
      fmt::format("{} affects {} of {}", path, own.size() + inherited.size(), counted(effects.size(), "component"));
  if (!own.empty()) text += fmt::format(": {}", fmt::join(own, ", "));
  if (!inherited.empty())
    text += fmt::format("; through {} {}", own.size() > 1 ? "them" : "it", fmt::join(inherited, ", "));
  return text;
}

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
    DrawingOptions drawn{.shows_types = options.types};
    if (!options.affects.empty()) {
      drawn.effects = affected_by(document, options.affects);
      if (!options.document.quiet) print_status(text_of_effects(document, options.affects, drawn.effects));
    }
    drawing = draw_graph(document.graph, drawn);
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
  command
      ->add_option("--affects", options->affects,
                   "Highlight the components that a variable (age), a parameter (leaf.length) or a key "
                   "(links[1].density) affects, and list them")
      ->type_name("NAME")
      ->excludes("--tree");
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
