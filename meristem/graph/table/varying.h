// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/base/track.h"
#include "meristem/graph/table/site.h"

namespace meristem {

struct MemberType;
struct Sample;

/// Writes a number to a struct's member of any number type.
using StoreNumber = void (*)(void* member, double value);

/// A range over siblings that changes with time.
struct KeyedRange {
  KeyTrack first;  ///< first end of the range over time
  KeyTrack last;   ///< last end of the range over time
};

/// A parameter that differs from instance to instance or changes with time. It has a range over the siblings, keys of
/// such a range, or a sample of measured values. An expression can replace or change the result.
///
/// With a sample, v is drawn for each instance by the instance's key and the parameter's name. With a range, child i of
/// n has v = first + i (last - first) / (n - 1), and v = first if n = 1. n can have a fraction if the last child is
/// still growing. The expression is applied to v. Results are clamped to the parameter's range. Results that are not
/// finite are an InputError at `path`.
struct Varying {
  std::string path;                          ///< in the document, for errors: "components.leaf.curl"
  std::uint64_t name_hash = 0;               ///< hash of the path within the component: selects the random stream
  double first = 0;                          ///< in document units
  double last = 0;                           ///< in document units
  std::shared_ptr<const Sample> sample;      ///< replaces the range: v is drawn from it; null: no sample
  std::shared_ptr<const KeyedRange> keys{};  ///< replaces the range: both ends over the time of the site's clock
  std::optional<Expression> expression;      ///< applied to v; unset: v is the value
  std::size_t names = 0;    ///< number of variables that the expression may use: site variables, and the values of
                            ///< sites
  double min = 0;           ///< least allowed value, in document units
  double max = 0;           ///< greatest allowed value, in document units
  bool is_rounded = false;  ///< true: a count by a range or an expression, which is rounded
  double scale = 1;         ///< factor from document units to the struct's units
  /// A step to an element of a list or map. Each instance stores it elsewhere in memory.
  struct Element {
    std::size_t offset = 0;            ///< bytes to the list, from the beginning of the struct or of the element before
    const MemberType* type = nullptr;  ///< type of the list or map
    std::size_t index = 0;             ///< index of the element
  };
  std::vector<Element> way;  ///< steps from the struct to the element that holds the member; empty: the struct holds it
  std::size_t offset = 0;    ///< offset of the member in its struct or element, bytes
  StoreNumber store = nullptr;  ///< writes the number to the member

  /// Returns the offset in the struct of the member, or of the list or map whose element holds the member, bytes.
  std::size_t offset_in_struct() const { return way.empty() ? offset : way.front().offset; }
};

/// A number that may differ among the children of one instance.
struct PerChild {
  double plain = 0;                ///< value for all children, in the struct's unit; used if `varying` is unset
  std::optional<Varying> varying;  ///< value per child: its i and n are the child's

  PerChild() = default;
  /// Makes a number that is equal for all children.
  PerChild(double value) : plain(value) {}  // NOLINT(google-explicit-constructor): a plain number is the usual case

  /// Returns true if both are certain to give equal numbers, which only plain numbers are.
  bool operator==(const PerChild& other) const { return !varying && !other.varying && plain == other.plain; }
};

/// The values of many parameters for a block of sites, computed together.
class VaryingValues {
 public:
  /// Computes `varyings` at all `sites` at a time of the document, seconds. Throws InputError for results that are not
  /// finite.
  VaryingValues(std::span<const Varying> varyings, std::span<const Site> sites, double time);
  /// Stores the values for the k-th site into the struct at `object`.
  void apply(std::size_t site, void* object) const;
  /// Returns the value of one varying number at one site, in the struct's unit.
  double value(std::size_t varying, std::size_t site) const { return values_[varying * count_ + site]; }

 private:
  std::span<const Varying> varyings_;
  std::size_t count_;
  std::vector<double> values_;  // by varying, then site
};

}  // namespace meristem
