// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/expression/expression.h"
#include "meristem/base/function_ref.h"
#include "meristem/base/limits.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/varying.h"

namespace meristem {

/// Where a number goes.
struct NumberSlot {
  void* member = nullptr;
  StoreNumber store = nullptr;
  double present = 0;  ///< the default, in document units: what an expression without a range sees as v
};

/// Reads values into structs by their tables, collects every fault with its place, and sets aside the numbers that
/// differ from instance to instance.
class ParameterReader {
 public:
  using ReadText =
      FunctionRef<void(const std::string& text, const std::string& path, std::vector<Diagnostic>& warnings)>;

  /// `constants` are the document's variables; paths of files start in `folder`, or where it is empty in the present
  /// one.
  ParameterReader(std::vector<ExpressionNames::Constant> constants, const Limits& limits, std::string folder = {})
      : constants_(std::move(constants)), limits_(limits), folder_(std::move(folder)) {}

  /// Reads `value` into the struct at `object`, where every number must be one number. Returns the rows that it gives.
  GivenRows read(const ParameterTable& table, void* object, const Value& value, const Place& place);
  /// The same for a component's struct: numbers in it, and in the elements of its lists, may vary from instance to
  /// instance and then end up in the result.
  std::vector<Varying> read_varying(const ParameterTable& table, void* object, const Value& value, const Place& place);

  void fault(const Place& place, std::string message, std::string expected = {}, std::string nearest = {},
             int text_offset = -1);
  /// The same for a member's name instead of its value.
  void fault_name(const Place& place, std::string message, std::string expected, std::string nearest);
  /// The candidate nearest to `name`, until so many faults are reported that no more are shown.
  std::string nearest(std::string_view name, std::span<const std::string> candidates) const;
  void warn(const Place& place, std::string message);
  /// The fault of `wanted` of `what` where the limit called `limit_name` allows fewer.
  void fault_limit(const Place& place, std::string_view what, double wanted, std::uint64_t limit,
                   std::string_view limit_name);
  const Limits& limits() const { return limits_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  std::vector<Diagnostic> take_diagnostics() { return std::move(diagnostics_); }
  std::size_t fault_count() const { return faults_; }

  // What tables are made of; each reports what it cannot take.

  /// One number in its form's range, written plainly or as an expression of the document's variables.
  std::optional<double> number(const Parameter& parameter, const Value& value, const Place& place);
  /// A number into its slot, at once or, where allowed, as a Varying.
  void store_number(const Parameter& parameter, const Value& value, const Place& place, const NumberSlot& slot);
  /// Whether a number that was read stands there as an expression or a range, and so may be another one for another
  /// instance or at another time.
  bool is_worked_out(const Place& place) const;
  /// A number that may differ among the children of an instance.
  void store_per_child(const Parameter& parameter, const Value& value, const Place& place, PerChild& number);
  /// An expression over `variables` and the document's variables.
  std::optional<Expression> expression(const Value& value, const Place& place, std::span<const std::string> variables);
  const std::string* text(const Parameter& parameter, const Value& value, const Place& place);
  std::optional<std::size_t> choice(const Parameter& parameter, const Value& value, const Place& place);
  /// Calls `load` with the full path of the file that `value` names; what it throws becomes faults at `place`.
  void file(const Parameter& parameter, const Value& value, const Place& place,
            FunctionRef<void(const std::string& path)> load);
  /// Calls `read` with a text that may stand as a list of its lines, and with a path in the document's folder. The
  /// faults that it throws and the warnings that it gives, by line and column, come to stand at their places in the
  /// document.
  void lines(const Parameter& parameter, const Value& value, const Place& place, ReadText read);
  /// The same for the text of a file.
  void text_file(const Parameter& parameter, const Value& value, const Place& place, ReadText read);
  /// The document's variables.
  const std::vector<ExpressionNames::Constant>& constants() const { return constants_; }
  void add_file(std::string path) { files_.push_back(std::move(path)); }
  /// The paths of all files that were named so far.
  const std::vector<std::string>& files() const { return files_; }
  /// The table's members from an object, or its shorthand from a bare value.
  GivenRows object(const ParameterTable& table, void* object, const Value& value, const Place& place);
  /// The element with this index of the list or map at `member`.
  void element(const Parameter& row, void* member, std::size_t index, const Value& value, const Place& place);
  void wrong_kind(const Parameter& parameter, const Value& value, const Place& place);

 private:
  void report_in_file(const Diagnostic& found, const std::string& file, const Place& place);
  void report_in_text(const Diagnostic& found, const Value& value, const Place& place);
  void report(const Place& place, const Diagnostic& found, int text_offset);
  void check_given(const ParameterTable& table, const GivenRows& given, const Place& place);
  std::optional<Varying> varying(const Parameter& parameter, const Value& value, const Place& place, double present);
  std::string_view why_one(const Parameter& parameter) const;
  bool check_range(const Parameter& parameter, double value, const Place& place, std::string_view what);

  std::vector<ExpressionNames::Constant> constants_;
  Limits limits_;
  std::string folder_;
  std::vector<std::string> files_;
  std::vector<std::string> worked_out_;  // document paths of numbers
  std::vector<Diagnostic> diagnostics_;
  std::size_t faults_ = 0;
  /// What a component's instances have copies of and is being read: its struct, or an element of a list in it.
  struct Holder {
    std::byte* object = nullptr;        // null where no component is read, so that no number may vary
    std::vector<Varying::Element> way;  // to it from the struct
  };
  Holder holder_;
  std::vector<Varying> varyings_;
};

}  // namespace meristem
