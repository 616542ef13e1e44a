// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "commands.h"
#include "documents.h"

namespace meristem::cli {

void add_check(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("check", "Say all that is wrong with a document, without growing it");
  auto options = std::make_shared<DocumentOptions>();
  options->add_to(*command);
  command->footer("Example: meristem check models/oak.json");
  command->callback([options, &run] {
    run = [options] {
      const Document document = open_document(*options);
      if (options->quiet) return;
      fmt::print("{}: good, {} components and {} links\n", document.source.file, document.graph.components.size(),
                 document.graph.links.size());
    };
  });
}

}  // namespace meristem::cli
