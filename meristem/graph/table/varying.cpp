// SPDX-License-Identifier: Apache-2.0
// Computes numbers that differ from instance to instance, for a block of sites at once. Numbers that differ per child
// are computed by the multiplier, over sites that have the children's numbers.
#include "meristem/graph/table/varying.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/sample.h"

namespace meristem {

namespace {

/// The site variables that an expression uses, as arrays over the sites.
class Columns {
 public:
  Columns(const Varying& varying, std::span<const Site> sites, const double* v, double time)
      : pointers_(std::max(varying.names, site_variables().size()), nullptr) {
    const Expression& expression = *varying.expression;
    pointers_[0] = v;
    for (std::size_t k = 1; k < pointers_.size(); ++k) {
      if (!expression.uses(k)) continue;
      std::vector<double>& column = storage_.emplace_back(sites.size());
      for (std::size_t s = 0; s < sites.size(); ++s) column[s] = site_variable(k, sites[s], 0, time);
      pointers_[k] = column.data();
    }
  }
  std::span<const double* const> pointers() const { return pointers_; }

 private:
  std::vector<std::vector<double>> storage_;
  std::vector<const double*> pointers_;
};

void evaluate_expression(const Varying& varying, std::span<const Site> sites, double time, double* values) {
  const Expression& expression = *varying.expression;
  std::vector<RandomKey> keys;
  if (expression.is_random()) {
    keys.reserve(sites.size());
    for (const Site& site : sites) keys.push_back(site.key.child(varying.name_hash));
  }
  const std::vector<double> v(values, values + sites.size());
  const Columns columns(varying, sites, v.data(), time);
  expression.evaluate(sites.size(), columns.pointers(), keys, values);
}

/// Returns the value of a number's range for one of the siblings.
double at_site(const Varying& varying, const Site& site, double time) {
  const double gaps = std::max(1.0, static_cast<double>(site.n) - 2 + static_cast<double>(site.part));
  const double share = site.n > 1 ? std::min(1.0, site.i / gaps) : 0;
  if (varying.keys == nullptr) return varying.first + share * (varying.last - varying.first);
  const double shown = site.clock.at(time);
  const double first = varying.keys->first.at(shown);
  return first + share * (varying.keys->last.at(shown) - first);
}

void check_and_clamp(const Varying& varying, std::span<const Site> sites, double* values) {
  for (std::size_t s = 0; s < sites.size(); ++s) {
    if (!std::isfinite(values[s])) {
      throw InputError(Diagnostic{.message = fmt::format("the expression '{}' gives {} for instance {} of {}",
                                                         varying.expression ? varying.expression->text() : "",
                                                         values[s], sites[s].i, sites[s].n),
                                  .expected = "a finite number for every instance",
                                  .path = varying.path});
    }
    if (varying.is_rounded) values[s] = std::floor(values[s] + 0.5);
    values[s] = std::clamp(values[s], varying.min, varying.max) * varying.scale;
  }
}

}  // namespace

VaryingValues::VaryingValues(std::span<const Varying> varyings, std::span<const Site> sites, double time)
    : varyings_(varyings), count_(sites.size()), values_(varyings.size() * sites.size()) {
  for (std::size_t k = 0; k < varyings.size(); ++k) {
    const Varying& varying = varyings[k];
    double* values = values_.data() + k * count_;
    for (std::size_t s = 0; s < count_; ++s) {
      const Site& site = sites[s];
      if (varying.sample != nullptr) {
        values[s] = varying.sample->quantile(site.key.child(varying.name_hash).child("sample").uniform(0));
        continue;
      }
      values[s] = at_site(varying, site, time);
    }
    if (varying.expression) evaluate_expression(varying, sites, time, values);
    check_and_clamp(varying, sites, values);
  }
}

void VaryingValues::apply(std::size_t site, void* object) const {
  for (std::size_t k = 0; k < varyings_.size(); ++k) {
    auto* holder = static_cast<std::byte*>(object);
    for (const Varying::Element& element : varyings_[k].way) {
      holder = static_cast<std::byte*>(element.type->element(holder + element.offset, element.index));
    }
    varyings_[k].store(holder + varyings_[k].offset, value(k, site));
  }
}

}  // namespace meristem
