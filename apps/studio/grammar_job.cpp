// SPDX-License-Identifier: Apache-2.0
#include "grammar_job.h"

#include <algorithm>
#include <optional>
#include <string>

#include "instance_value.h"
#include "meristem/components/lsystem_trace.h"

namespace meristem::studio {

namespace {

/// Returns the modules of a word from `first` up to `end`, each as a text.
Value::List module_texts(const Word& word, const Alphabet& alphabet, std::size_t first, std::size_t end) {
  Value::List texts;
  Word one;
  std::size_t parameter = 0;
  for (std::size_t k = 0; k < end; ++k) {
    const std::size_t arity = alphabet[word.letters[k]].arity;
    if (k >= first) {
      one.letters.assign(1, word.letters[k]);
      const auto begin = word.parameters.begin() + static_cast<std::ptrdiff_t>(parameter);
      one.parameters.assign(begin, begin + static_cast<std::ptrdiff_t>(arity));
      texts.push_back(word_text(one, alphabet));
    }
    parameter += arity;
  }
  return texts;
}

/// Returns seven numbers for each drawn module in the range: its index, its beginning and its end.
Value::List places_within(const std::vector<DrawnModule>& places, std::size_t first, std::size_t end) {
  Value::List numbers;
  for (const DrawnModule& place : places) {
    if (place.module < first || place.module >= end) continue;
    numbers.push_back(static_cast<double>(place.module));
    for (const Vec3 point : {place.from, place.to}) {
      for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<double>(point[axis]));
    }
  }
  return numbers;
}

}  // namespace

Value derivation(const Document& read, const GrammarRequest& request, double time, Progress& progress) {
  std::optional<Document> other;
  const Document& document = document_at(read, time, other, &progress);
  const std::optional<LsystemTrace> trace =
      trace_lsystem(document.graph, document.scene, request.component,
                    {.steps = request.step, .key = request.key, .number = request.number}, time, progress);
  if (!trace) return Value::Object{{"text", Value()}};
  const bool is_as_drawn = request.is_drawn || !trace->is_interpreted;
  const Word& word = request.is_drawn ? trace->drawn : trace->derived;
  const std::size_t first = std::min<std::size_t>(request.first, word.module_count());
  const std::size_t end = first + std::min<std::size_t>(request.count, word.module_count() - first);
  Value::List counts;
  for (const auto& [symbol, count] : symbol_counts(word, trace->alphabet))
    counts.push_back(Value::List{symbol, static_cast<double>(count)});
  return Value::Object{{"instance", Value::Object{{"number", static_cast<double>(trace->number)},
                                                  {"of", static_cast<double>(trace->count)},
                                                  {"key", instance_key(trace->site)}}},
                       {"text", trace->text},
                       {"steps", trace->steps},
                       {"step", request.step.value_or(trace->steps)},
                       {"interpreted", trace->is_interpreted},
                       {"count", static_cast<double>(word.module_count())},
                       {"counts", std::move(counts)},
                       {"first", static_cast<double>(first)},
                       {"modules", module_texts(word, trace->alphabet, first, end)},
                       {"places", is_as_drawn ? places_within(trace->places, first, end) : Value::List{}}};
}

}  // namespace meristem::studio
