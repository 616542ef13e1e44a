// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "apps/studio/job_watch.h"
#include "apps/studio/page_files.h"
#include "apps/studio/redirect_page.h"
#include "apps/studio/server.h"
#include "commands.h"
#include "documents.h"
#include "meristem/document/models.h"
#include "terminal.h"

namespace meristem::cli {

namespace {

namespace fs = std::filesystem;

struct StudioOptions {
  std::string document;
  std::string root;
  int port = -1;
  double job_seconds = studio::StudioLimits().job_seconds;
  bool no_browser = false;
};

/// Returns true if the user has a desktop, which can open a browser.
bool has_desktop() { return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr; }

/// Opens a page in the user's browser.
void open_browser(const studio::RedirectPage& page) {
  const pid_t child = ::fork();
  if (child != 0) {
    // The child ends at once. The browser is opened by a grandchild, which needs no waiting.
    while (child > 0 && ::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
    return;
  }
  // Makes a new session, so that Ctrl-C in the terminal does not end the browser, and the browser's output does not mix
  // with the studio's.
  ::setsid();
  if (::fork() != 0) _exit(0);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (nowhere < 0 || ::dup2(nowhere, stream) < 0) _exit(1);
  }
  ::execlp("xdg-open", "xdg-open", page.path().c_str(), static_cast<char*>(nullptr));
  _exit(1);
}

/// Returns the folder to serve: the requested one, else the document's folder, else the present folder.
std::string served_folder(const StudioOptions& options, const std::string& file) {
  if (!options.root.empty()) return options.root;
  if (file.empty()) return ".";
  const std::string folder = fs::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

void run_studio(const StudioOptions& options) {
  const std::string models = models_folder();
  std::string file;
  std::string model;
  if (!options.document.empty()) {
    file = find_document(options.document, models);
    const std::string name = fs::path(file).stem().string();
    if (file == model_path(models, name)) {
      model = name;
      file.clear();
    }
  }
  studio::Host host{
      .registry = components(), .root = studio::RootFolder(served_folder(options, file)), .models_folder = models};
  host.has_picture = &studio::has_model_picture;
  host.limits.job_seconds = options.job_seconds;
  if (const std::uint64_t memory = studio::memory_of_machine(); memory > 0) {
    host.limits.memory_bytes = std::min(host.limits.memory_bytes, memory / 4 * 3);
  }
  if (options.document.empty()) model = "oak";
  if (!model.empty()) host.model = model;
  if (!file.empty()) {
    host.document = host.root.relative(file);
    if (!host.document) {
      throw InputError(Diagnostic{.message = fmt::format("'{}' is not in the folder '{}'", file, options.root),
                                  .expected = "a document below --root"});
    }
    host.root.read(*host.document);  // reports faults of the document now
  }
  studio::ServeOptions serving;
  if (options.port >= 0) serving.port = static_cast<std::uint16_t>(options.port);
  std::optional<studio::RedirectPage> redirect;  // lives until the studio ends, because browsers may start slowly
  serving.on_end = [&redirect] { redirect.reset(); };
  studio::serve(host, serving, [&](const std::string& address) {
    if (!studio::has_page())
      print_status("meristem: this program was built without the studio's page, which needs node");
    fmt::print("{}\n", address);
    std::fflush(stdout);
    if (options.no_browser || !has_desktop()) return;
    try {
      open_browser(redirect.emplace(address));
    } catch (const MachineError& error) {
      print_status(fmt::format("meristem: no browser was opened: {}", error.what()));
    }
  });
}

}  // namespace

void add_studio(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("studio", "Grow and change a document in a browser");
  auto options = std::make_shared<StudioOptions>();
  command
      ->add_option("document", options->document,
                   "A plant document or the name of a shipped model; by default, the oak")
      ->type_name("DOC");
  command
      ->add_option(
          "--port", options->port,
          fmt::format("Port of 127.0.0.1 to listen on; by default, the first free one from {}", studio::kUsualPort))
      ->type_name("N")
      ->check(CLI::Range(0, 65535));
  command->add_flag("--no-browser", options->no_browser, "Print the address and open no browser");
  command
      ->add_option(
          "--root", options->root,
          "Folder below which all files are read and written; by default, the document's folder, or the current one")
      ->type_name("DIR");
  command
      ->add_option("--job-seconds", options->job_seconds,
                   fmt::format("Seconds after which one growth, export or measurement is stopped; by default, {}",
                               options->job_seconds))
      ->type_name("S")
      ->check(CLI::Range(0.001, 1e6));
  add_plugin_option(*command);
  command->footer("Example: meristem studio oak\nCtrl-C ends it.");
  command->callback([options, &run] { run = [options] { run_studio(*options); }; });
}

}  // namespace meristem::cli
