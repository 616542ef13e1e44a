// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/graph/table/site.h"

namespace meristem {

/// An expression over the names that its parameter allows, as the document wrote it.
struct ParameterFormula {
  std::string text;       ///< as the document wrote it
  Expression expression;  ///< compiled

  bool operator==(const ParameterFormula& other) const { return text == other.text; }
};

/// A formula over sites along a stem or over instances. A result other than 0 means true.
using SiteCondition = ParameterFormula;

/// A set of instances: numbers, ranges of numbers with both ends, and conditions over the site variables.
struct InstanceSelection {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges;  ///< first and last number, both included
  std::vector<SiteCondition> conditions;                        ///< an instance that meets one of them is selected
  std::size_t names = 0;                                        ///< variables that conditions may use

  bool is_empty() const { return ranges.empty() && conditions.empty(); }  ///< true if it selects nothing
  /// Returns true if the instance at a site is selected.
  bool contains(const Site& site, double time) const;
};

}  // namespace meristem
