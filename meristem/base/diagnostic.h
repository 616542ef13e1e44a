// SPDX-License-Identifier: Apache-2.0
// What a user can cause becomes a Diagnostic: where, what is wrong, what was expected, the nearest valid name.
// Checking collects all of them; loading throws one InputError that carries them.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// Whether a diagnostic stops the input from being used.
enum class Severity { warning, error };

/// Diagnostic::text_offset of a fault in a member's name and not in its value.
inline constexpr int kAtName = -2;

/// One thing that is wrong, or odd, with an input, and its place.
struct Diagnostic {
  Severity severity = Severity::error;  ///< an error, or a warning beside which the input can be used
  std::string message;                  ///< what is wrong, without a full stop: "'lenght' is not a parameter of a leaf"
  std::string expected;                 ///< what was expected, or empty: "a number of metres in 0 to 10"
  std::string nearest;                  ///< the nearest valid name, or empty
  std::string path;                     ///< document path, or empty: "components.stem.angle", "links[1].density"
  std::string file;                     ///< as the user wrote it, "<standard input>", or empty where not known yet
  int line = 0;                         ///< from 1; 0 where not known
  int column = 0;                       ///< in characters (not bytes) from 1; 0 where not known
  int text_offset = -1;  ///< the byte in the text at `path` (an expression's fault), or -1 for the whole value

  /// One line: `file:line:column: path: message; expected ...; did you mean 'nearest'?`, leaving out what is not known.
  std::string text() const;
};

/// Everything that is wrong with an input. `what()` has one line a diagnostic, and `warning: ` before those that are
/// none of the faults.
class InputError : public std::runtime_error {
 public:
  /// Carries these diagnostics, at least one.
  explicit InputError(std::vector<Diagnostic> diagnostics);
  explicit InputError(Diagnostic diagnostic) : InputError(std::vector{std::move(diagnostic)}) {}
  /// All faults and warnings, in the order of the input.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// The machine's failure and not the input's: disk full, path refused. Carries the path and the system's reason.
class MachineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The candidate nearest to `name` by edits (insert, delete, replace, swap neighbours; capitals count as equal), or
/// empty where none is within a third of the name's length. Ties go to the earlier candidate. Names and candidates over
/// 100 bytes do not count.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

}  // namespace meristem
