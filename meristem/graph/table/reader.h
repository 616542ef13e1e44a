// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/expression/expression.h"
#include "meristem/base/expression/expression_scope.h"
#include "meristem/base/function_ref.h"
#include "meristem/base/limits.h"
#include "meristem/base/name_table.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/file_access.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/plant_source.h"
#include "meristem/graph/table/read_store.h"
#include "meristem/graph/table/varying.h"

namespace meristem {

/// Number of names that reading one document compares with unknown names to propose a similar name.
inline constexpr std::size_t kMaxNamesCompared = 2'000'000;

/// The destination of a number.
struct NumberSlot {
  void* member = nullptr;       ///< member of the struct
  StoreNumber store = nullptr;  ///< writes the number to the member
  double present = 0;           ///< the default, in document units: what an expression without a range sees as v
};

/// Reads values into structs by their tables and collects every fault with its path. Numbers that differ from instance
/// to instance are returned as Varying.
class ParameterReader {
 public:
  /// Takes a text and the path of its file, and adds warnings by line and column.
  using ReadText =
      FunctionRef<void(const std::string& text, const std::string& file_path, std::vector<Diagnostic>& warnings)>;

  /// `constants` are the document's variables.
  ParameterReader(std::vector<ExpressionNames::Constant> constants, const SizeLimits& limits, FileAccess access = {})
      : constants_(std::move(constants)),
        limits_(limits),
        instance_names_(site_variables()),
        access_(std::move(access)) {}

  /// Adds names that the expressions of instances may use besides the site variables. Applies to later reads.
  void add_instance_names(std::span<const std::string> names) { instance_names_.add(names); }
  /// Sets the reason that messages give for a name that cannot be used: "is a column of texts".
  void refuse_instance_name(const std::string& name, std::string reason) { refused_names_[name] = std::move(reason); }
  /// Returns all names that the expressions of instances may use, the site variables first.
  const std::vector<std::string>& instance_names() const { return instance_names_.names(); }

  /// Reading throws Cancelled soon after `progress` was asked to stop. Null: reading cannot be stopped.
  void stop_with(const Progress* progress) { progress_ = progress; }
  /// Throws Cancelled if reading was asked to stop.
  void check_stop() const {
    if (progress_ != nullptr) progress_->check();
  }

  /// Returns the document that a component names, ready to grow. Returns null after faults at `path`.
  std::shared_ptr<const PlantSource> plant_source(const std::string& name, const DocumentPath& path);

  /// Reads `value` into the struct at `object`. Every number must be a single number. Returns the rows that `value`
  /// gives.
  GivenRows read(const ParameterTable& table, void* object, const Value& value, const DocumentPath& path);
  /// Reads `value` into a component's struct. Returns the numbers, including those in the elements of its lists, that
  /// vary from instance to instance.
  std::vector<Varying> read_varying(const ParameterTable& table, void* object, const Value& value,
                                    const DocumentPath& path);

  /// Reports a fault of a value. `text_offset` is the byte within a text value, or -1 for the whole value.
  void add_error(const DocumentPath& path, std::string message, std::string expected = {}, std::string nearest = {},
                 int text_offset = -1);
  /// Reports a fault at a member's name instead of its value.
  void error_name(const DocumentPath& path, std::string message, std::string expected, std::string nearest);
  /// Reports a parameter that has no effect at its position, or no effect beside `other`.
  void error_meaning(const DocumentPath& path, std::string message, std::string expected,
                     const DocumentPath* other = nullptr);
  /// Paths of a parameter without effect, and of the parameter that prevents an effect, if there is one.
  struct Meaningless {
    std::string file_path;  ///< path of the parameter
    std::string other;      ///< path of the other parameter, or empty
  };
  /// Returns the parameters without effect, in the order of reading.
  const std::vector<Meaningless>& meaningless() const { return meaningless_; }
  /// Returns the candidate nearest to `name`. Returns an empty text once the number of faults exceeds what is shown, or
  /// once all searches together have compared kMaxNamesCompared candidates. Many faults among many names therefore cost
  /// little time.
  std::string nearest(std::string_view name, std::span<const std::string> candidates) const;
  /// Adds a warning at a value.
  void warn(const DocumentPath& path, std::string message);
  /// Reports that `wanted` of `what` exceed the limit called `limit_name`.
  void error_limit(const DocumentPath& path, std::string_view what, double wanted, std::uint64_t limit,
                   std::string_view limit_name);
  const SizeLimits& limits() const { return limits_; }                         ///< limits of the document
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }  ///< faults and warnings so far
  /// Returns the faults and warnings, and leaves none.
  std::vector<Diagnostic> take_diagnostics() { return std::move(diagnostics_); }
  std::size_t error_count() const { return errors_; }  ///< number of all faults; diagnostics() may hold fewer

  // The functions below are used by tables. Each reports values that it cannot accept.

  /// Reads one number in its form's range, written plainly or as an expression of the document's variables.
  std::optional<double> number(const Parameter& parameter, const Value& value, const DocumentPath& path);
  /// Stores a number into its slot: at once, or as a Varying if that is allowed.
  void store_number(const Parameter& parameter, const Value& value, const DocumentPath& path, const NumberSlot& slot);
  /// Returns true if a number that was read is written as an expression or a range. Its value may then depend on the
  /// instance or the time.
  bool is_worked_out(const DocumentPath& path) const;
  /// Returns true while a component is read, in which numbers may vary.
  bool reads_component() const { return holder_.object != nullptr; }
  /// Reads a number that may differ among the children of an instance.
  void store_per_child(const Parameter& parameter, const Value& value, const DocumentPath& path, PerChild& number);
  /// Reads an expression over `variables` and the document's variables.
  std::optional<Expression> expression(const Value& value, const DocumentPath& path,
                                       std::span<const std::string> variables);
  /// Returns the text of a value; null after a fault.
  const std::string* text(const Parameter& parameter, const Value& value, const DocumentPath& path);
  /// Returns the index of a choice; nothing after a fault.
  std::optional<std::size_t> choice(const Parameter& parameter, const Value& value, const DocumentPath& path);
  /// Calls `load` with the full path of the file that `value` names. Exceptions of `load` become faults at `path`.
  void file(const Parameter& parameter, const Value& value, const DocumentPath& path,
            FunctionRef<void(const std::string& file_path)> load);
  /// Calls `read` with a text, which may be given as a list of its lines, and with a path in the document's folder.
  /// Faults and warnings with a line and column are moved to their position in the document.
  void lines(const Parameter& parameter, const Value& value, const DocumentPath& path, ReadText read);
  /// Calls `read` with the text of the file that `value` names, as `lines` does with a text.
  void text_file(const Parameter& parameter, const Value& value, const DocumentPath& path, ReadText read);
  /// Returns the document's variables.
  const std::vector<ExpressionNames::Constant>& constants() const { return constants_.all(); }
  /// Returns the document's variables with a table of their names.
  const ConstantTable& constant_table() const { return constants_; }
  /// Returns the text of a file that another file includes. The path starts at the folder of the including file. Throws
  /// an InputError.
  std::string included_text(const std::string& file, const std::string& name, std::uint64_t max_bytes);
  /// Returns all files that were named so far.
  const std::vector<NamedFile>& files() const { return files_; }

  /// Returns the result of `make`, or its result in an earlier read with this key. The key must cover everything that
  /// the result depends on.
  template <class T, class Make>
  std::shared_ptr<const T> kept(const Fingerprint& key, Make make) {
    if (access_.store == nullptr) return std::make_shared<const T>(make());
    std::shared_ptr<const T> made = access_.store->find<T>(key.hash());
    if (made == nullptr) {
      made = std::make_shared<const T>(make());
      access_.store->keep<T>(key.hash(), made);
    }
    return made;
  }
  /// Returns what `load` makes of the file at `path`, or its result in an earlier read. reader.file() must have named
  /// the file.
  template <class T>
  std::shared_ptr<const T> kept_file(const std::string& file_path, T (*load)(const std::string&, const SizeLimits&)) {
    const std::optional<std::uint64_t> hash = file_hash(file_path);
    if (!hash) return std::make_shared<const T>(load(file_path, limits_));
    Fingerprint key = fingerprint_of_loading(reinterpret_cast<void (*)()>(load));
    return kept<T>(key.add_text(file_path).add(*hash), [&] { return load(file_path, limits_); });
  }
  /// Returns what `make_of` makes of a text, or its result in an earlier read. Warnings are reported in both cases.
  template <class T>
  std::shared_ptr<const T> kept_text(const std::string& text, const std::string& file_path,
                                     std::vector<Diagnostic>& warnings,
                                     T (*make_of)(const std::string&, const std::string&, ParameterReader&,
                                                  std::vector<Diagnostic>&)) {
    struct Read {
      std::shared_ptr<const T> made;
      std::vector<Diagnostic> warnings;
      std::vector<NamedFile> files;
    };
    const auto make = [&] {
      const std::size_t files_before = files_.size();
      Read made{std::make_shared<const T>(make_of(text, file_path, *this, warnings)), warnings, {}};
      made.files.assign(files_.begin() + static_cast<std::ptrdiff_t>(files_before), files_.end());
      return made;
    };
    if (access_.store == nullptr) return make().made;
    Fingerprint key = fingerprint_of_loading(reinterpret_cast<void (*)()>(make_of));
    key.add_text(file_path).add_text(text);
    key.add(fingerprint_of_constants());
    std::shared_ptr<const Read> found = access_.store->find<Read>(key.hash());
    if (found == nullptr || !are_present(found->files)) {
      found = std::make_shared<const Read>(make());
      access_.store->keep<Read>(key.hash(), found);
      return found->made;
    }
    warnings = found->warnings;
    files_.insert(files_.end(), found->files.begin(), found->files.end());
    return found->made;
  }
  /// Sets the document paths of values that stand for keys of the animation, as {"keys": [[time, value, way], ...]}.
  void expect_keys(const std::vector<std::string>& paths) { keyed_ = {paths.begin(), paths.end()}; }
  /// Collects the paths of all expressions that are read from now on. Null stops the collection.
  void note_expressions(std::vector<std::string>* paths) { expression_paths_ = paths; }
  /// Reads the table's members from an object, or its shorthand from a bare value.
  GivenRows object(const ParameterTable& table, void* object, const Value& value, const DocumentPath& path);
  /// Reads the element with this index of the list or map at `member`.
  void element(const Parameter& row, void* member, std::size_t index, const Value& value, const DocumentPath& path);
  /// Reports a value that is not of the row's kind.
  void wrong_kind(const Parameter& parameter, const Value& value, const DocumentPath& path);

 private:
  void report_in_file(const Diagnostic& found, const std::string& file, const DocumentPath& path);
  void report_in_text(const Diagnostic& found, const Value& value, const DocumentPath& path);
  void report(const DocumentPath& path, const Diagnostic& found, int text_offset);
  void check_given(const ParameterTable& table, const GivenRows& given, const DocumentPath& path);
  void check_members(const Value& value, const DocumentPath& path);
  std::optional<Varying> varying(const Parameter& parameter, const Value& value, const DocumentPath& path,
                                 double present);
  std::string_view why_one(const Parameter& parameter) const;
  bool check_range(const Parameter& parameter, double value, const DocumentPath& path, std::string_view what);

  ConstantTable constants_;
  std::optional<std::uint64_t> constants_hash_;
  SizeLimits limits_;
  NameTable instance_names_;
  const Progress* progress_ = nullptr;
  mutable std::size_t names_compared_ = 0;
  std::map<std::string, std::string, std::less<>> refused_names_;
  /// Returns the hash of a file from the store, or nothing if there is no store.
  std::optional<std::uint64_t> file_hash(const std::string& file_path);
  void name_file(NamedFile file);
  bool is_below_folder(const std::string& file_path) const;
  Fingerprint fingerprint_of_loading(void (*load)()) const;
  std::uint64_t fingerprint_of_constants();
  bool are_present(const std::vector<NamedFile>& files);

  FileAccess access_;
  std::vector<NamedFile> files_;
  std::vector<std::string>* expression_paths_ = nullptr;
  std::unordered_set<std::string> worked_out_;  // document paths of numbers
  std::unordered_set<std::string> keyed_;       // document paths of numbers with keys
  std::vector<Diagnostic> diagnostics_;
  std::vector<Meaningless> meaningless_;
  std::size_t errors_ = 0;
  /// The struct that is being read and that every instance copies: a component's struct, or an element of a list in it.
  struct Holder {
    std::byte* object = nullptr;        // null if no component is read: then no number may vary
    std::vector<Varying::Element> way;  // steps from the component's struct to it
  };
  Holder holder_;
  std::vector<Varying> varyings_;
};

}  // namespace meristem
