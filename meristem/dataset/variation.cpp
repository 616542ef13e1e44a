// SPDX-License-Identifier: Apache-2.0
// Draws values from distributions by keys, so that a value does not depend on the order of draws. Bounds are kept by
// repeated draws. Uniform and triangular distributions use the inverse of the distribution function.
#include "meristem/dataset/variation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "meristem/base/math.h"

namespace meristem {

namespace {

/// A kind, and the form of its list of numbers.
struct VariationForm {
  std::string_view name;
  std::size_t count;  // number of numbers; 0: any number of choices
  std::string_view numbers;
};

constexpr std::array<VariationForm, 7> kVariationForms{{
    {"uniform", 2, "[low, high]"},
    {"log_uniform", 2, "[low, high], both above 0"},
    {"normal", 2, "[mean, standard deviation]"},
    {"lognormal", 2, "[median, standard deviation of the logarithm], both above 0"},
    {"triangular", 3, "[low, most frequent, high]"},
    {"integer", 2, "[lowest, highest], whole numbers"},
    {"choice", 0, "a list of values"},
}};

/// Number of draws outside the bounds after which the nearer bound is used. This hardly ever happens if a hundredth of
/// the values lies within the bounds.
constexpr std::uint64_t kMaxDraws = 10'000;

double normal_share_below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

double share_below(const ValueVariation& variation, double x) {
  const std::vector<double>& n = variation.numbers;
  const auto along = [](double at, double low, double high) {
    return high > low ? std::clamp((at - low) / (high - low), 0.0, 1.0) : at >= low ? 1.0 : 0.0;
  };
  switch (variation.kind) {
    case ValueVariation::Kind::uniform:
      return along(x, n[0], n[1]);
    case ValueVariation::Kind::log_uniform:
      return x > 0 ? along(std::log(x), std::log(n[0]), std::log(n[1])) : 0;
    case ValueVariation::Kind::normal:
      return n[1] > 0 ? normal_share_below((x - n[0]) / n[1]) : along(x, n[0], n[0]);
    case ValueVariation::Kind::lognormal:
      return x > 0 ? normal_share_below(std::log(x / n[0]) / n[1]) : 0;
    case ValueVariation::Kind::triangular: {
      if (!(n[2] > n[0])) return along(x, n[0], n[0]);
      const double at = std::clamp(x, n[0], n[2]);
      if (at < n[1]) return (at - n[0]) * (at - n[0]) / ((n[2] - n[0]) * (n[1] - n[0]));
      if (n[2] == n[1]) return 1;
      return 1 - (n[2] - at) * (n[2] - at) / ((n[2] - n[0]) * (n[2] - n[1]));
    }
    case ValueVariation::Kind::integer:
      return along(std::floor(x) + 1, n[0], n[1] + 1);
    case ValueVariation::Kind::choice:
      return 1;
  }
  return 1;
}

double draw_number(const ValueVariation& variation, RandomKey key, std::uint64_t draw) {
  const std::vector<double>& n = variation.numbers;
  switch (variation.kind) {
    case ValueVariation::Kind::uniform:
      return n[0] + (n[1] - n[0]) * key.uniform(draw);
    case ValueVariation::Kind::log_uniform:
      return n[0] * math::exp(math::log(n[1] / n[0]) * key.uniform(draw));
    case ValueVariation::Kind::normal:
      return n[0] + n[1] * key.normal(draw);
    case ValueVariation::Kind::lognormal:
      return n[0] * math::exp(n[1] * key.normal(draw));
    case ValueVariation::Kind::triangular: {
      if (!(n[2] > n[0])) return n[0];
      const double share = key.uniform(draw);
      const double turn = (n[1] - n[0]) / (n[2] - n[0]);
      if (share < turn) return n[0] + std::sqrt(share * (n[2] - n[0]) * (n[1] - n[0]));
      return n[2] - std::sqrt((1 - share) * (n[2] - n[0]) * (n[2] - n[1]));
    }
    case ValueVariation::Kind::integer:
      return n[0] + std::floor(key.uniform(draw) * (n[1] - n[0] + 1));
    case ValueVariation::Kind::choice:
      break;
  }
  return 0;
}

/// Returns a list of `count` finite numbers, or nothing.
std::optional<std::vector<double>> finite_numbers(const Value& value, std::size_t count) {
  const Value::List* const list = value.list();
  if (list == nullptr || list->size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const Value& element : *list) {
    if (element.number() == nullptr || !std::isfinite(*element.number())) return std::nullopt;
    numbers.push_back(*element.number());
  }
  return numbers;
}

/// Returns true if the numbers are valid for the kind.
bool are_right(ValueVariation::Kind kind, const std::vector<double>& n) {
  switch (kind) {
    case ValueVariation::Kind::uniform:
      return n[0] <= n[1];
    case ValueVariation::Kind::log_uniform:
      return n[0] > 0 && n[0] <= n[1];
    case ValueVariation::Kind::normal:
      return n[1] >= 0;
    case ValueVariation::Kind::lognormal:
      return n[0] > 0 && n[1] > 0;
    case ValueVariation::Kind::triangular:
      return n[0] <= n[1] && n[1] <= n[2];
    case ValueVariation::Kind::integer:
      return n[0] <= n[1] && n[0] == std::floor(n[0]) && n[1] == std::floor(n[1]) && std::abs(n[0]) < 1e15 &&
             std::abs(n[1]) < 1e15;
    case ValueVariation::Kind::choice:
      return true;
  }
  return false;
}

bool read_choices(const Value& whole, const Value& choices, const DocumentPath& path, ParameterReader& reader,
                  ValueVariation& variation) {
  const Value::List* const list = choices.list();
  if (list == nullptr || list->empty()) {
    reader.add_error(DocumentPath(path, "choice"), fmt::format("the choices are {}", choices.description()),
                     "a list of at least one value");
    return false;
  }
  variation.choices = *list;
  const Value* const weights = whole.find("weights");
  if (weights == nullptr) return true;
  const auto numbers = finite_numbers(*weights, list->size());
  const bool is_right = numbers && std::all_of(numbers->begin(), numbers->end(), [](double w) { return w >= 0; }) &&
                        std::any_of(numbers->begin(), numbers->end(), [](double w) { return w > 0; });
  if (!is_right) {
    reader.add_error(DocumentPath(path, "weights"), fmt::format("the weights are {}", weights->description()),
                     fmt::format("{} numbers, one per choice, none below 0 and not all 0", list->size()));
    return false;
  }
  variation.weights = *numbers;
  return true;
}

}  // namespace

Value ValueVariation::draw(RandomKey key) const {
  if (kind == Kind::choice) {
    double rest = key.uniform(0);
    if (weights.empty()) return choices[static_cast<std::size_t>(rest * static_cast<double>(choices.size()))];
    double sum = 0;
    for (const double weight : weights) sum += weight;
    rest *= sum;
    std::size_t last = 0;  // last choice with a weight
    for (std::size_t k = 0; k < weights.size(); ++k) {
      if (weights[k] > 0) last = k;
      if (rest < weights[k]) return choices[k];
      rest -= weights[k];
    }
    return choices[last];
  }
  double number = 0;
  for (std::uint64_t k = 0; k < kMaxDraws; ++k) {
    number = draw_number(*this, key, k);
    if ((!low || number >= *low) && (!high || number <= *high)) return number;
  }
  return low && number < *low ? *low : high.value_or(number);
}

double ValueVariation::share_within() const {
  if (kind == Kind::choice) return 1;
  // A distribution without width lies entirely within or outside the bounds.
  const bool is_point =
      kind == Kind::normal ? numbers[1] == 0 : kind != Kind::lognormal && numbers.front() == numbers.back();
  if (is_point) return (!low || numbers[0] >= *low) && (!high || numbers[0] <= *high) ? 1 : 0;
  const double below_low = !low ? 0 : share_below(*this, kind == Kind::integer ? std::ceil(*low) - 1 : *low);
  return (high ? share_below(*this, *high) : 1) - below_low;
}

std::vector<Value> ValueVariation::ends() const {
  if (kind == Kind::choice) return choices;
  std::optional<double> first = low;
  std::optional<double> last = high;
  if (kind != Kind::normal && kind != Kind::lognormal) {
    first = std::max(numbers.front(), low.value_or(numbers.front()));
    last = std::min(numbers.back(), high.value_or(numbers.back()));
  }
  std::vector<Value> ends;
  if (first) ends.emplace_back(*first);
  if (last && last != first) ends.emplace_back(*last);
  if (ends.empty()) ends.emplace_back(numbers[0]);
  return ends;
}

bool ValueVariation::is_number() const {
  return std::all_of(choices.begin(), choices.end(), [](const Value& value) { return value.number() != nullptr; });
}

std::optional<ValueVariation> read_variation(const Value& value, const DocumentPath& path, ParameterReader& reader) {
  std::vector<std::string> names;
  for (const VariationForm& form : kVariationForms) names.emplace_back(form.name);
  const std::string expected =
      fmt::format("an object with one of {}, such as {{\"uniform\": [20, 60]}}", fmt::join(names, ", "));
  if (value.object() == nullptr) {
    reader.add_error(path, fmt::format("a distribution cannot be {}", value.description()), expected);
    return std::nullopt;
  }
  std::size_t kinds = 0;
  ValueVariation variation;
  for (const auto& [name, member] : *value.object()) {
    const auto known = std::find(names.begin(), names.end(), name);
    if (known != names.end()) {
      ++kinds;
      variation.kind = static_cast<ValueVariation::Kind>(known - names.begin());
    } else if (name != "within" && name != "weights") {
      std::vector<std::string> all = names;
      all.insert(all.end(), {"within", "weights"});
      reader.add_name_error(DocumentPath(path, name), fmt::format("'{}' is not a part of a distribution", name),
                            fmt::format("one of {}", fmt::join(all, ", ")), nearest_name(name, all));
      return std::nullopt;
    }
  }
  if (kinds != 1) {
    reader.add_error(path, kinds == 0 ? "the distribution has no kind" : "the distribution has more than one kind",
                     expected);
    return std::nullopt;
  }
  const VariationForm& form = kVariationForms.at(static_cast<std::size_t>(variation.kind));
  const Value& given = *value.find(form.name);
  const bool chooses = variation.kind == ValueVariation::Kind::choice;
  if (const Value* weights = value.find("weights"); weights != nullptr && !chooses) {
    reader.add_name_error(DocumentPath(path, "weights"), "weights belong to choices", "\"choice\" beside \"weights\"",
                          "");
    return std::nullopt;
  }
  if (chooses) {
    if (!read_choices(value, given, path, reader, variation)) return std::nullopt;
  } else {
    const auto numbers = finite_numbers(given, form.count);
    if (!numbers || !are_right(variation.kind, *numbers)) {
      reader.add_error(DocumentPath(path, form.name), fmt::format("'{}' cannot be {}", form.name, given.description()),
                       std::string(form.numbers));
      return std::nullopt;
    }
    variation.numbers = *numbers;
  }
  const Value* const within = value.find("within");
  if (within == nullptr) return variation;
  const auto bounds = finite_numbers(*within, 2);
  if (chooses || !bounds || !((*bounds)[0] <= (*bounds)[1])) {
    reader.add_error(DocumentPath(path, "within"),
                     chooses ? "choices have no bounds" : fmt::format("the bounds are {}", within->description()),
                     chooses ? "a list of the choices that are meant" : "two numbers [low, high]");
    return std::nullopt;
  }
  variation.low = (*bounds)[0];
  variation.high = (*bounds)[1];
  return variation;
}

}  // namespace meristem
