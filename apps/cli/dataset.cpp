// SPDX-License-Identifier: Apache-2.0
// The command `dataset`: makes, resumes, checks and repairs data sets of many plants. All threads take ranges of plants
// from the folder, as the workers of Python do, so the bytes are equal.
#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "meristem/base/counted.h"
#include "meristem/base/limits.h"
#include "meristem/base/parallel.h"
#include "meristem/base/read_file.h"
#include "meristem/dataset/dataset_folder.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/dataset_links.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/plant_maker.h"
#include "meristem/dataset/plant_range.h"
#include "meristem/dataset/verify_dataset.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kErrorsPrinted = 100;

struct DatasetCommand {
  std::string plan;    // a plan's file, or the folder of a data set
  std::string output;  // the folder
  bool fresh = false;
  bool repair = false;
  bool verify = false;
  bool allow_old = false;
  std::string root;
  int threads = 0;
  bool quiet = false;
};

bool is_dataset(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(dataset_info_path(path), error);
}

void verify(const DatasetCommand& command) {
  const std::string& folder = command.output.empty() ? command.plan : command.output;
  require_within(command.root, folder);
  const ThreadLimit threads = limited_threads(command.threads, command.quiet);
  DatasetCheck check;
  {
    TerminalProgress terminal(command.quiet);
    check = verify_dataset(folder, components(), models_folder(), terminal.progress(),
                           {.root = command.root, .allow_old = command.allow_old});
  }
  for (const std::string& warning : check.warnings) print_status("warning: " + warning);
  for (std::size_t k = 0; k < check.errors.size() && k < kErrorsPrinted; ++k) print_status(check.errors[k]);
  if (check.errors.size() > kErrorsPrinted) {
    print_status(fmt::format("and {} more", check.errors.size() - kErrorsPrinted));
  }
  if (!command.quiet) {
    print_status(fmt::format("{}: {} of {} plants, {} failed, {}, {:.1f} MB, {}", folder, check.rows, check.plants,
                             check.failed, counted(check.files, "file"), static_cast<double>(check.bytes) / 1e6,
                             !check.errors.empty()     ? counted(check.errors.size(), "fault")
                             : !check.warnings.empty() ? "as written as far as it was checked"
                                                       : "all as written"));
  }
  // One fault is the missing hashes themselves.
  if (check.is_old && !command.allow_old && check.errors.size() == 1) {
    throw MachineError(
        fmt::format("the tables of '{0}' could not be checked; --allow-old accepts them as they are, and 'meristem "
                    "dataset {0}' adds hashes of them as they are now",
                    folder));
  }
  if (!check.errors.empty()) {
    throw MachineError(fmt::format(
        "'{0}' is not what its manifest says; meristem dataset PLAN -o {0} --repair makes again what is wrong",
        folder));
  }
}

/// Returns the plan of a file, or of a data set that was begun.
DatasetPlan plan_of(const DatasetCommand& command) {
  if (command.plan != "-") require_within(command.root, command.plan);
  const bool is_begun = is_dataset(command.plan);
  const std::string file = is_begun ? folder_plan_path(command.plan) : command.plan;
  std::error_code ignored;
  if (file != "-") require_within(command.root, file);
  if (fs::is_directory(file, ignored)) throw no_dataset(file);
  if (is_begun && command.repair) {
    try {
      return read_dataset_plan(begun_plan_text(command.plan), file, components(),
                               {.models = models_folder(), .root = command.root});
    } catch (const InputError& error) {
      print_diagnostics(error.diagnostics());
      throw MachineError(
          fmt::format("'{0}' cannot be repaired from the folder alone: its plan or a document cannot be read any more; "
                      "the plan that "
                      "it was begun with makes it again: meristem dataset PLAN -o {0} --repair",
                      command.plan));
    }
  }
  // Throws with the nearest existing name
  if (file != "-" && !fs::exists(file, ignored)) read_file(file, SizeLimits().file_bytes);
  return read_dataset_plan(read_text_file(file), file, components(), {.models = models_folder(), .root = command.root});
}

/// Makes all missing plants of a data set, on as many threads as allowed.
void make_all(DatasetFolder& folder, const DatasetPlan& plan, TerminalProgress& terminal) {
  Progress& progress = terminal.progress();
  const DocumentFolders folders{.documents = documents_path(folder.path()), .models = models_folder()};
  std::mutex mutex;
  std::atomic<bool> has_failed{false};
  terminal.tell_parts("plant", folder.done(), folder.found(), folder.total());
  progress.begin("growing", folder.total() - folder.found());
  parallel_for(static_cast<std::size_t>(thread_count()), 1, [&](std::size_t, std::size_t) {
    const ThreadLimit alone(1);
    Progress own(&progress);
    PlantMaker maker(plan, components(), folders);
    try {
      while (!has_failed) {
        std::optional<PlantRange> range;
        {
          const std::scoped_lock lock(mutex);
          range = folder.next();
        }
        if (!range) return;
        const auto begin = std::chrono::steady_clock::now();
        make_range(maker, plan, *range, folder.path(), own);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        const std::scoped_lock lock(mutex);
        folder.add(*range, seconds);
        terminal.tell_parts("plant", folder.done(), folder.found(), folder.total());
        progress.advance(range->count());
      }
    } catch (...) {
      has_failed = true;
      throw;
    }
  });
}

void tell_made(const std::string& path, std::uint64_t plants, std::uint64_t found,
               const std::vector<std::string>& errors, std::uint64_t error_count) {
  for (const std::string& error : errors) print_status(error);
  if (error_count > errors.size()) print_status(fmt::format("and {} more", error_count - errors.size()));
  if (error_count > 0) print_status(fmt::format("{}: what was not right was made again", path));
  print_status(fmt::format("{}: {}{}", path, counted(plants, "plant"),
                           found > 0 ? fmt::format(", {} of them were there", found) : ""));
}

/// Throws InputError if a link in an existing folder leads out of the root. Covers files that are read and files that
/// are written.
void require_links_within_root(const DatasetCommand& command) {
  if (is_dataset(command.plan)) require_links_within(command.plan, command.root);
  if (!command.output.empty()) require_links_within(command.output, command.root);
}

void make(const DatasetCommand& command) {
  require_links_within_root(command);
  const DatasetPlan plan = plan_of(command);
  if (!command.quiet) print_diagnostics(plan.warnings);
  const std::string path = command.output.empty() && is_dataset(command.plan) ? command.plan : command.output;
  if (path.empty()) {
    throw InputError(Diagnostic{.message = "no folder for the data set is given", .expected = "-o DIR"});
  }
  const ThreadLimit threads = limited_threads(command.threads, command.quiet);
  std::vector<std::string> errors;
  std::uint64_t error_count = 0;
  std::uint64_t found = 0;
  std::string failed;
  {
    TerminalProgress terminal(command.quiet);
    const DatasetOpening opening = command.fresh    ? DatasetOpening::fresh
                                   : command.repair ? DatasetOpening::repair
                                                    : DatasetOpening::resume;
    DatasetFolder folder(plan, path, opening, terminal.progress());
    errors = folder.errors();
    error_count = folder.error_count();
    found = folder.found();
    make_all(folder, plan, terminal);
    folder.finish(terminal.progress());
    if (folder.failed() > 0) failed = fmt::format("{}: {}", path, folder.failed_text());
  }
  if (!command.quiet) tell_made(path, plan.count(), found, errors, error_count);
  if (!failed.empty()) throw PartlyDone(failed);
}

}  // namespace

void add_dataset(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("dataset", "Make a data set of many plants from a plan, go on with one, or check one");
  auto options = std::make_shared<DatasetCommand>();
  command->add_option("plan", options->plan, "A plan in JSON, or the folder of a data set that was begun")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->output,
                   "Folder of the data set; one that holds a part of this data set is gone on with")
      ->type_name("DIR");
  CLI::Option* const fresh = command->add_flag("--fresh", options->fresh,
                                               "Refuse a folder that holds a data set, instead of going on with it");
  CLI::Option* const repair = command->add_flag(
      "--repair", options->repair,
      "Read all that is there, make again the plants whose rows or files have changed, put back plan, documents and "
      "hashes, and remove files that belong to nothing");
  CLI::Option* const verify_flag =
      command->add_flag("--verify", options->verify,
                        "Make nothing; compare all files with the manifest, and the manifest with its hashes and "
                        "with the values that the plan draws");
  command
      ->add_flag(
          "--allow-old", options->allow_old,
          "With --verify: only warn if an earlier version of the program made the data set, whose tables have no "
          "hashes and cannot be checked")
      ->needs(verify_flag);
  fresh->excludes(repair)->excludes(verify_flag);
  repair->excludes(verify_flag);
  add_plugin_option(*command);
  add_root_option(*command, options->root);
  add_run_options(*command, options->threads, options->quiet);
  command->footer(
      "Example: meristem dataset oaks.json -o oaks\n"
      "         meristem dataset oaks --verify\n"
      "Exit codes: 0 done, 1 failed, not as written or not checked, 2 wrong plan, 3 some plants have failed");
  command->callback([options, &run] { run = [options] { options->verify ? verify(*options) : make(*options); }; });
}

}  // namespace meristem::cli
