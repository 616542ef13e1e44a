// SPDX-License-Identifier: Apache-2.0
// An error that a user can cause becomes a Diagnostic: its place, the problem, what was expected, and the nearest valid
// name. Checks collect all diagnostics. Loading throws one InputError that carries them.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// Whether a diagnostic makes the input unusable.
enum class Severity { warning, error };

/// Value of Diagnostic::text_offset if the error is in the name of a member, not in its value.
inline constexpr int kAtName = -2;

/// One error or warning about an input, and its place.
struct Diagnostic {
  Severity severity = Severity::error;  ///< error, or warning with which the input is still usable
  std::string message;                  ///< the problem, without a full stop: "'lenght' is not a parameter of a leaf"
  std::string expected;                 ///< what was expected, or empty: "a number of metres in 0 to 10"
  std::string nearest;                  ///< the nearest valid name, or empty
  std::string path;                     ///< document path, or empty: "components.stem.angle", "links[1].density"
  std::string file;                     ///< file name as the user wrote it, "<standard input>", or empty if not yet
                                        ///< known
  int line = 0;                         ///< line from 1; 0 if unknown
  int column = 0;                       ///< column in characters (not bytes) from 1; 0 if unknown
  int text_offset = -1;  ///< byte of the error in the text at `path` (for expressions), or -1 for the whole value

  /// Returns one line: `file:line:column: path: message; expected ...; did you mean 'nearest'?`. Unknown parts are left
  /// out.
  std::string text() const;
};

/// All errors and warnings of an input. `what()` has one line per diagnostic, and warnings begin with `warning: `.
class InputError : public std::runtime_error {
 public:
  /// `diagnostics` must have at least one entry.
  explicit InputError(std::vector<Diagnostic> diagnostics);
  explicit InputError(Diagnostic diagnostic) : InputError(std::vector{std::move(diagnostic)}) {}
  /// Returns all errors and warnings, in the order of the input.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// A failure of the machine and not of the input: full disk, refused path. Carries the path and the system's reason.
class MachineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the candidate that needs the fewest edits to become `name` (insert, delete, replace, swap neighbours;
/// capital and small letters are equal). Returns an empty text if the edits exceed a third of the name's length. Ties
/// go to the earlier candidate. Names and candidates over 100 bytes are ignored.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

}  // namespace meristem
