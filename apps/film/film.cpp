// SPDX-License-Identifier: Apache-2.0
#include "film.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_file.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): not every system's header has it

namespace meristem::film {

namespace {

namespace fs = std::filesystem;

constexpr const char* kMaker = "ffmpeg";
constexpr std::uint64_t kMaxOfLog = 4'000'000;  // bytes
constexpr std::chrono::milliseconds kBetweenWaits{20};

/// The program in the folders of PATH; empty where there is none.
std::string maker() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder.empty() ? "." : folder) / kMaker;
    if (access(file.c_str(), X_OK) == 0) return file.string();
  }
  return "";
}

/// What the codecs of a file's ending need.
std::vector<std::string> codec(const std::string& path) {
  if (path.ends_with(".webm")) return {"-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-row-mt", "1"};
  return {"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart"};
}

/// Waits for the end of a program, or ends it when asked to stop. Returns its exit code.
int exit_code(pid_t process, const std::string& program, const Progress& progress) {
  for (;;) {
    int status = 0;
    const pid_t ended = waitpid(process, &status, WNOHANG);
    if (ended == process) return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    if (ended < 0 && errno != EINTR)
      throw MachineError(fmt::format("{}: {}", program, std::generic_category().message(errno)));
    if (progress.is_cancelled()) {
      kill(process, SIGKILL);  // what it has written so far is no film
      while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
      }
      progress.check();
    }
    std::this_thread::sleep_for(kBetweenWaits);
  }
}

/// Runs a program to its end without a shell; what it writes goes to the file `log`. Returns its exit code. Throws
/// Cancelled.
int run(const std::vector<std::string>& words, const std::string& log, const Progress& progress) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t process = 0;
  const int failed = posix_spawn(&process, words[0].c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) throw MachineError(fmt::format("{}: {}", words[0], std::generic_category().message(failed)));
  return exit_code(process, words[0], progress);
}

/// Returns the lines of a text that are not empty.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

}  // namespace

bool is_film(const std::string& path) { return path.ends_with(".mp4") || path.ends_with(".webm"); }

bool can_make_films() { return !maker().empty(); }

void check_film(const std::string& path, int width, int height) {
  if (maker().empty()) {
    throw InputError(Diagnostic{.message = fmt::format("'{}' needs the program ffmpeg, which is not installed", path),
                                .expected = "ffmpeg (apt install ffmpeg), or numbered pictures: -o film.png"});
  }
  if (width % 2 == 0 && height % 2 == 0) return;
  throw InputError(Diagnostic{.message = fmt::format("a film cannot have {} x {} pixels", width, height),
                              .expected = "an even width and height, such as --size 800x600"});
}

std::string frames_folder(const std::string& path, std::uint64_t what_they_show) {
  const std::string folder = fmt::format("{}.{:016x}.frames", path, what_they_show);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw MachineError(fmt::format("{}: {}", folder, error.message()));
  return folder;
}

std::string frame_path(const std::string& folder, std::size_t frame) {
  return (fs::path(folder) / fmt::format("{:05}.png", frame)).string();
}

void make_film(const std::string& folder, std::size_t frames, double fps, const std::string& path,
               const Progress& progress) {
  const std::string ending = fs::path(path).extension().string();
  const std::string made = (fs::path(folder) / ("film" + ending)).string();
  const std::string log = (fs::path(folder) / "ffmpeg.log").string();
  std::vector<std::string> words{maker(),      "-y",
                                 "-loglevel",  "error",
                                 "-framerate", fmt::format("{:.9g}", fps),
                                 "-i",         (fs::path(folder) / "%05d.png").string(),
                                 "-frames:v",  fmt::format("{}", frames)};
  for (std::string& word : codec(path)) words.push_back(std::move(word));
  for (const char* const word : {"-pix_fmt", "yuv420p"}) words.emplace_back(word);
  words.push_back(made);
  if (const int code = run(words, log, progress); code != 0) {
    throw MachineError(fmt::format("{}: ffmpeg has failed with code {}: {}", path, code,
                                   fmt::join(lines_of(read_file(log, kMaxOfLog)), "; ")));
  }
  std::error_code error;
  fs::rename(made, path, error);
  if (error) throw MachineError(fmt::format("{}: {}", path, error.message()));
  fs::remove_all(folder, error);
}

}  // namespace meristem::film
