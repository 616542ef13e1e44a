// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Number of names that reading one document compares with unknown names to propose a similar name.
inline constexpr std::size_t kMaxNamesCompared = 2'000'000;

/// Collects the errors and warnings of the values of one document, each with its path. At most
/// SizeLimits::diagnostics errors are kept, but all are counted.
class ReadErrors {
 public:
  /// `limits` are the document's limits.
  explicit ReadErrors(const SizeLimits& limits) : limits_(limits) {}

  /// Reports an error of a value. `text_offset` is the byte within a text value, or -1 for the whole value.
  void add_error(const DocumentPath& path, std::string message, std::string expected = {}, std::string nearest = {},
                 int text_offset = -1);
  /// Reports an error at a member's name instead of its value.
  void add_name_error(const DocumentPath& path, std::string message, std::string expected, std::string nearest);
  /// Reports a parameter that has no effect at its position, or no effect beside `other`.
  void add_meaning_error(const DocumentPath& path, std::string message, std::string expected,
                         const DocumentPath* other = nullptr);
  /// Reports that `wanted` of `what` exceed the limit called `limit_name`.
  void add_limit_error(const DocumentPath& path, std::string_view what, double wanted, std::uint64_t limit,
                       std::string_view limit_name);
  /// Reports a value that is not of the row's kind.
  void wrong_kind(const Parameter& parameter, const Value& value, const DocumentPath& path);
  /// Adds a warning at a value.
  void warn(const DocumentPath& path, std::string message);
  /// Reports an error or a warning that a reader of files or texts has found. `text_offset` is as in `add_error`.
  void add_found(const DocumentPath& path, const Diagnostic& found, int text_offset = -1);

  /// Returns the candidate nearest to `name`. Returns an empty text once the number of errors exceeds what is shown, or
  /// once all searches together have compared kMaxNamesCompared candidates. Many errors among many names therefore cost
  /// little time.
  std::string nearest(std::string_view name, std::span<const std::string> candidates) const;
  /// Returns true if further searches for similar names may compare `count` candidates.
  bool may_compare(std::size_t count) const;
  /// Counts the candidates of a search that another class has made.
  void count_compared(std::size_t count) const { names_compared_ += count; }

  /// Paths of a parameter without effect, and of the parameter that prevents an effect, if there is one.
  struct Meaningless {
    std::string file_path;  ///< path of the parameter
    std::string other;      ///< path of the other parameter, or empty
  };
  /// Returns the parameters without effect, in the order of reading.
  const std::vector<Meaningless>& meaningless() const { return meaningless_; }
  const SizeLimits& limits() const { return limits_; }                         ///< limits of the document
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }  ///< errors and warnings so far
  /// Returns the errors and warnings, and leaves none.
  std::vector<Diagnostic> take_diagnostics() { return std::move(diagnostics_); }
  std::size_t error_count() const { return errors_; }  ///< number of all errors; diagnostics() may hold fewer

 private:
  SizeLimits limits_;
  mutable std::size_t names_compared_ = 0;
  std::vector<Diagnostic> diagnostics_;
  std::vector<Meaningless> meaningless_;
  std::size_t errors_ = 0;
};

}  // namespace meristem
