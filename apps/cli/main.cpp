// SPDX-License-Identifier: Apache-2.0
// The command line. Exit codes: 0 success, 1 failure, 2 the command line or the document is wrong, 3 some plants of a
// data set have failed. A signal ends the program as usual, after unfinished files have been removed.
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <system_error>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "build_info.h"
#include "commands.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/progress.h"
#include "meristem/base/version.h"
#include "terminal.h"

namespace {

using namespace meristem;

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongInput = 2;
constexpr int kPartlyDone = 3;

/// Returns the answer to --version, such as "meristem 0.1.0 (72fe62c0, Release)". Omits facts that are unknown.
std::string version_line() {
  std::string facts(build_commit());
  if (!facts.empty() && !build_type().empty()) facts += ", ";
  facts += build_type();
  return facts.empty() ? fmt::format("meristem {}", version()) : fmt::format("meristem {} ({})", version(), facts);
}

/// Returns the valid word nearest to an unexpected word of the command line.
std::string nearest_word(const CLI::App& app, const std::string& word) {
  std::vector<std::string> words;
  const auto chosen = app.get_subcommands();
  const CLI::App& asked = chosen.empty() ? app : *chosen.front();
  for (const CLI::App* command : asked.get_subcommands([](const CLI::App*) { return true; }))
    words.push_back(command->get_name());
  for (const CLI::Option* option : asked.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  return nearest_name(word, words);
}

int report_usage(const CLI::App& app, const CLI::ParseError& error) {
  Diagnostic diagnostic{.message = error.what()};
  const std::vector<std::string> extras = app.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extras.empty()) {
    diagnostic.message = fmt::format("'{}' was not expected", extras.front());
    diagnostic.nearest = nearest_word(app, extras.front());
  }
  const auto chosen = app.get_subcommands();
  cli::print_status("meristem: " + diagnostic.text());
  cli::print_status(fmt::format("'meristem {}--help' lists what is allowed.",
                                chosen.empty() ? "" : chosen.front()->get_name() + " "));
  return kWrongInput;
}

/// Ends the program as the signal would have ended it, so that shells and makefiles notice.
int end_by_signal() {
  cli::print_status("meristem: stopped; no file was left half-written");
  std::signal(cli::received_signal(), SIG_DFL);
  std::raise(cli::received_signal());
  return kFailed;
}

int run_and_report(const cli::Run& run) {
  try {
    run();
    if (std::fflush(stdout) != 0)
      throw std::system_error(errno, std::generic_category(), "cannot write standard output");
    return kDone;
  } catch (const InputError& error) {
    cli::print_diagnostics(error.diagnostics());
    return kWrongInput;
  } catch (const Cancelled&) {
    return end_by_signal();
  } catch (const cli::PartlyDone& error) {
    cli::print_status(error.what());
    return kPartlyDone;
  } catch (const std::system_error& error) {
    // The reader of the output has closed the pipe, as `head` does. This needs no message.
    if (error.code() != std::errc::broken_pipe) cli::print_status(fmt::format("meristem: {}", error.what()));
  } catch (const std::bad_alloc&) {
    cli::print_status("meristem: out of memory; lower the document's limits or its counts");
  } catch (const std::exception& error) {
    cli::print_status(fmt::format("meristem: {}", error.what()));
  }
  return kFailed;
}

/// Ends the program with a message. The system may refuse a thread that a library needs, and such an exception cannot
/// be caught.
[[noreturn]] void end_with_a_word() {
  std::string reason = "an unexpected error";
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::exception& error) {
    reason = error.what();
  } catch (...) {
  }
  cli::print_status(fmt::format("meristem: {}; fewer threads take less memory: --threads 1", reason));
  std::_Exit(kFailed);
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_with_a_word);
  CLI::App app("Grows plants from documents into meshes and pictures.", "meristem");
  app.set_version_flag("--version", version_line());
  app.require_subcommand(0, 1);
  app.footer("Example: meristem grow oak -o oak.glb");
  cli::Run run;
  cli::add_grow(app, run);
  cli::add_render(app, run);
  cli::add_measure(app, run);
  cli::add_shade(app, run);
  cli::add_scan(app, run);
  cli::add_derive(app, run);
  cli::add_graph(app, run);
  cli::add_check(app, run);
  cli::add_combine(app, run);
  cli::add_plan(app, run);
  cli::add_dataset(app, run);
  cli::add_components(app, run);
  cli::add_models(app, run);
  cli::add_studio(app, run);
  cli::add_completion(app, run);
  std::signal(SIGPIPE, SIG_IGN);  // writing to a closed pipe fails like any other write
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    std::ostringstream text;  // text of --help or --version
    app.exit(request, text, text);
    return run_and_report([&text] { fmt::print("{}", text.str()); });
  } catch (const CLI::ParseError& error) {
    return report_usage(app, error);
  } catch (const InputError& error) {  // thrown by a plug-in
    cli::print_diagnostics(error.diagnostics());
    return kWrongInput;
  }
  if (!run) run = [&app] { fmt::print("{}", app.help()); };
  return run_and_report(run);
}
