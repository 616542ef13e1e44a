// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stdexcept>

#include <CLI/App.hpp>

namespace meristem::cli {

// Each function adds its subcommand to `app`. If the user chose the subcommand, `run` then holds its work.
using Run = std::function<void()>;

/// Thrown by a command that has done its work, but not for all parts: exit code 3. The message is the last line.
class PartlyDone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void add_grow(CLI::App& app, Run& run);
void add_render(CLI::App& app, Run& run);
void add_measure(CLI::App& app, Run& run);
void add_shade(CLI::App& app, Run& run);
void add_scan(CLI::App& app, Run& run);
void add_derive(CLI::App& app, Run& run);
void add_graph(CLI::App& app, Run& run);
void add_check(CLI::App& app, Run& run);
void add_combine(CLI::App& app, Run& run);
void add_plan(CLI::App& app, Run& run);
void add_dataset(CLI::App& app, Run& run);
void add_components(CLI::App& app, Run& run);
void add_models(CLI::App& app, Run& run);
void add_studio(CLI::App& app, Run& run);
void add_completion(CLI::App& app, Run& run);

}  // namespace meristem::cli
