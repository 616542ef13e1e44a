// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/graph/table/expression_reader.h"
#include "meristem/graph/table/file_reader.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/read_errors.h"
#include "meristem/graph/table/varying.h"

namespace meristem {

/// The destination of a number.
struct NumberSlot {
  void* member = nullptr;       ///< member of the struct
  StoreNumber store = nullptr;  ///< writes the number to the member
  double present = 0;           ///< the default, in document units: what an expression without a range sees as v
};

/// Reads numbers. While the struct of a component is read, its numbers may differ from instance to instance.
class NumberReader {
 public:
  /// The arguments must outlive the reader.
  NumberReader(ExpressionReader& expressions, FileReader& files, ReadErrors& errors)
      : expressions_(expressions), files_(files), errors_(errors) {}

  /// Reads one number in its form's range, written plainly or as an expression of the document's variables.
  std::optional<double> read(const Parameter& parameter, const Value& value, const DocumentPath& path);
  /// Stores a number into its slot: at once, or as a Varying if that is allowed.
  void store(const Parameter& parameter, const Value& value, const DocumentPath& path, const NumberSlot& slot);
  /// Reads a number that may differ among the children of an instance.
  void store_per_child(const Parameter& parameter, const Value& value, const DocumentPath& path, PerChild& number);
  /// Returns true if a number that was read is written as an expression or a range. Its value may then depend on the
  /// instance or the time.
  bool is_worked_out(const DocumentPath& path) const { return worked_out_.contains(path.text()); }
  /// Sets the document paths of values that stand for keys of the animation, as {"keys": [[time, value, way], ...]}.
  void expect_keys(const std::vector<std::string>& paths) { keyed_ = {paths.begin(), paths.end()}; }

  /// Reading throws Cancelled soon after `progress` was asked to stop. Null: reading cannot be stopped.
  void stop_with(const Progress* progress) { progress_ = progress; }
  /// Throws Cancelled if reading was asked to stop.
  void check_stop() const {
    if (progress_ != nullptr) progress_->check();
  }

  /// Begins the struct of a component at `object`, in which numbers may vary.
  void begin_component(void* object);
  /// Ends the struct of a component. Returns the numbers, including those in elements of its lists, that vary from
  /// instance to instance.
  std::vector<Varying> end_component();
  /// Returns true while a component is read.
  bool reads_component() const { return holder_ != nullptr; }
  /// During its lifetime, numbers belong to an element of a list or map. No effect outside components.
  class InElement {
   public:
    /// `list` is the list or map of this type, and `element` its element with this index.
    InElement(NumberReader& reader, const void* list, const MemberType* type, std::size_t index, void* element);
    ~InElement();
    InElement(const InElement&) = delete;
    InElement& operator=(const InElement&) = delete;

   private:
    NumberReader& reader_;
    std::byte* holder_;
  };

 private:
  std::optional<Varying> varying(const Parameter& parameter, const Value& value, const DocumentPath& path,
                                 double present);
  bool read_range(const Parameter& parameter, const Value& value, const DocumentPath& path, Varying& varying);
  void check_members(const Value& value, const DocumentPath& path);
  std::string_view why_one(const Parameter& parameter) const;
  bool check_range(const Parameter& parameter, double value, const DocumentPath& path, std::string_view what);

  ExpressionReader& expressions_;
  FileReader& files_;
  ReadErrors& errors_;
  const Progress* progress_ = nullptr;
  std::unordered_set<std::string> worked_out_;  // document paths of numbers
  std::unordered_set<std::string> keyed_;       // document paths of numbers with keys
  // The struct that is being read and that every instance copies: a component's struct, or an element of a list in it.
  std::byte* holder_ = nullptr;        // null if no component is read
  std::vector<Varying::Element> way_;  // steps from the component's struct to the holder
  std::vector<Varying> varyings_;      // of the component that is read
};

}  // namespace meristem
