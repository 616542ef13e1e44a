// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "commands.h"
#include "documents.h"

namespace meristem::cli {

void add_check(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("check", "Report all that is wrong with a document, without growing it");
  auto options = std::make_shared<DocumentOptions>();
  options->add_to(*command);
  command->footer("Example: meristem check models/oak.json");
  command->callback([options, &run] {
    run = [options] {
      const Document document = open_document(*options);
      if (options->quiet) return;
      const auto counted = [](std::size_t count, const char* what) {
        return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
      };
      fmt::print("{}: good, {} and {}\n", document.source.file, counted(document.graph.components.size(), "component"),
                 counted(document.graph.links.size(), "link"));
    };
  });
}

}  // namespace meristem::cli
