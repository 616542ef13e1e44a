// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/grammar_include.h"

#include <unordered_map>

#include <fmt/format.h>

#include "meristem/base/progress.h"
#include "meristem/grow/lsystem/derive.h"

namespace meristem {

namespace {

/// Compiles every number once.
class NumberExpressions {
 public:
  const Expression& operator[](double number) {
    const std::string text = fmt::format("{}", number);
    const auto known = expressions_.find(text);
    if (known != expressions_.end()) return known->second;
    return expressions_.emplace(text, Expression::compile(text, {})).first->second;
  }

 private:
  std::unordered_map<std::string, Expression> expressions_;
};

}  // namespace

std::vector<ModuleTemplate> included_word(const Grammar& included, double steps, const SizeLimits& limits,
                                          Alphabet& alphabet) {
  // Random numbers of included words use a fixed key: an included word is a part of the grammar, not of the plant.
  const RandomKey key = RandomKey().child("include");
  Progress progress;
  SizeLimits bounded = limits;
  bounded.modules = std::min(limits.modules, kLongestIncludedWord);
  const Word derived = derive(included, steps, key.child("derive"), bounded, progress);
  const Word word = interpreted(included, derived, key.child("draw"), bounded, progress);

  std::vector<LetterIndex> ours(included.alphabet.size(), kNoLetter);
  std::vector<ModuleTemplate> forms;
  forms.reserve(word.module_count());
  NumberExpressions numbers;
  std::size_t parameter = 0;
  for (const LetterIndex letter : word.letters) {
    const Letter& theirs = included.alphabet[letter];
    if (ours[letter] == kNoLetter) ours[letter] = alphabet.add(theirs.symbol, theirs.arity);
    ModuleTemplate& form = forms.emplace_back();
    form.letter = ours[letter];
    for (std::size_t k = 0; k < theirs.arity; ++k) form.parameters.push_back(numbers[word.parameters[parameter++]]);
  }
  return forms;
}

}  // namespace meristem
