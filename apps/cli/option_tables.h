// SPDX-License-Identifier: Apache-2.0
// Shell completions and the man page, made from the names and the help of all commands' options.
#pragma once

#include <string>

#include <CLI/App.hpp>

namespace meristem::cli {

/// Returns a script that completes commands, options, file names, shells and the names of shipped models. `shell` is
/// bash, zsh or fish.
std::string completion_script(const CLI::App& app, const std::string& shell);

/// Returns the page meristem(1) in the macros of man.
std::string man_page(const CLI::App& app);

}  // namespace meristem::cli
