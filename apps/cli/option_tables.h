// SPDX-License-Identifier: Apache-2.0
// What the options of all commands say of themselves, for shells and for the man page: the same words as the help's.
#pragma once

#include <string>

#include <CLI/App.hpp>

namespace meristem::cli {

/// A script that completes commands, options, file names, shells and the names of shipped models. `shell` is one of
/// bash, zsh and fish.
std::string completion_script(const CLI::App& app, const std::string& shell);

/// meristem(1), in the macros of man.
std::string man_page(const CLI::App& app);

}  // namespace meristem::cli
