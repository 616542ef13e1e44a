// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/models.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "meristem/document/json.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

std::string text_member(const Value& document, const char* name) {
  const Value* member = document.find(name);
  return member != nullptr && member->text() != nullptr ? *member->text() : std::string();
}

void list_models(bool paths, bool names) {
  const std::string folder = models_folder();
  std::vector<std::string> listed = model_names(folder);
  for (std::string& film : film_names(folder)) listed.push_back(std::move(film));
  for (const std::string& name : listed) {
    if (names) {
      print_line(name);
    } else if (paths) {
      print_line(model_path(folder, name));
    } else {
      const Value document = parse_json(read_text_file(model_path(folder, name)));
      print_line(fmt::format("{:<16} {}", name, text_member(document, "description")));
    }
  }
}

}  // namespace

void add_models(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("models", "List the shipped models, and then the shipped films");
  auto paths = std::make_shared<bool>(false);
  auto names = std::make_shared<bool>(false);
  command->add_flag("--paths", *paths, "Print the paths of their files");
  command->add_flag("--names", *names, "Print only their names")->excludes("--paths");
  command->footer("Example: meristem models");
  command->callback([paths, names, &run] { run = [paths, names] { list_models(*paths, *names); }; });
}

}  // namespace meristem::cli
