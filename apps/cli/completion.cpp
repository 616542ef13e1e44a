// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "commands.h"
#include "option_tables.h"

namespace meristem::cli {

void add_completion(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("completion", "Print a script with which a shell completes commands and options");
  auto shell = std::make_shared<std::string>();
  auto manual = std::make_shared<bool>(false);
  CLI::Option* const named = command->add_option("shell", *shell, "Shell to complete in: bash, zsh or fish")
                                 ->type_name("SHELL")
                                 ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  CLI::Option* const man = command->add_flag("--man", *manual, "Print the man page instead");
  named->excludes(man);
  command->footer("Example: meristem completion bash > ~/.local/share/bash-completion/completions/meristem");
  command->callback([shell, manual, &app, &run] {
    if (shell->empty() && !*manual) throw CLI::RequiredError("shell");
    run = [shell, manual, &app] { fmt::print("{}", *manual ? man_page(app) : completion_script(app, *shell)); };
  });
}

}  // namespace meristem::cli
