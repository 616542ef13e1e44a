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

/// Writes a number to a struct's member of whatever number type it is.
using StoreNumber = void (*)(void* member, double value);

/// A range over siblings that changes with time.
struct KeyedRange {
  Track first;  ///< first end of the range over time
  Track last;   ///< last end of the range over time
};

/// A parameter that differs from instance to instance or changes with time: a range over the siblings, keys of one, or
/// a sample of measured values; an expression; or both.
///
/// For an instance with a sample v is drawn from that, by the instance's key and the parameter's name.
/// For child i of n a range gives v = first + i (last - first) / (n - 1), and first if n = 1. n can have a fraction, if
/// the last child is still growing. The expression is
/// applied to that v. Results are clamped to the parameter's range; results that are not finite are an InputError at
/// `path`.
struct Varying {
  std::string path;                          ///< in the document, for errors: "components.leaf.curl"
  std::uint64_t name_hash = 0;               ///< hash of the path within the component: the random stream's purpose
  double first = 0;                          ///< in document units
  double last = 0;                           ///< in document units
  std::shared_ptr<const Sample> sample;      ///< replaces the range: v is drawn from it; null: no sample
  std::shared_ptr<const KeyedRange> keys{};  ///< replaces the range: both ends over the time of the site's clock
  std::optional<Expression> expression;      ///< applied to v; unset: v is the value
  std::size_t names = 0;    ///< variables that the expression may use: the variables of sites, and what sites are given
  double min = 0;           ///< least allowed value, in document units
  double max = 0;           ///< greatest allowed value, in document units
  bool is_rounded = false;  ///< a count by a range or an expression: whole
  double scale = 1;         ///< from document units to the struct's
  /// An element of a list or map, which lies elsewhere in memory in each instance.
  struct Element {
    std::size_t offset = 0;            ///< bytes to the list, from the beginning of the struct or of the element before
    const MemberType* type = nullptr;  ///< type of the list or map
    std::size_t index = 0;             ///< index of the element
  };
  std::vector<Element> way;  ///< from the struct to the element that holds the member; empty where that is the struct
  std::size_t offset = 0;    ///< bytes to the member, from the beginning of what holds it
  StoreNumber store = nullptr;  ///< writes the number to the member
};

/// A number that differs among the children that one instance makes, or is one for all of them.
struct PerChild {
  double plain = 0;                ///< in the struct's unit, where it does not differ
  std::optional<Varying> varying;  ///< over the children: its i and n are theirs

  PerChild() = default;
  /// One number for all children.
  PerChild(double value) : plain(value) {}  // NOLINT(google-explicit-constructor): a plain number is the usual case

  /// Whether they are known to give equal numbers: plain ones alone are.
  bool operator==(const PerChild& other) const { return !varying && !other.varying && plain == other.plain; }
};

/// The values of many parameters for a block of sites, evaluated together.
class VaryingValues {
 public:
  /// Evaluates `varyings` at all `sites` at a time of the document, seconds. Throws InputError for results that are not
  /// finite.
  VaryingValues(std::span<const Varying> varyings, std::span<const Site> sites, double time);
  /// Stores the values for the k-th site into the struct at `object`.
  void apply(std::size_t site, void* object) const;
  /// The value of one varying number at one site, in the struct's unit.
  double value(std::size_t varying, std::size_t site) const { return values_[varying * count_ + site]; }

 private:
  std::span<const Varying> varyings_;
  std::size_t count_;
  std::vector<double> values_;  // by varying, then site
};

}  // namespace meristem
