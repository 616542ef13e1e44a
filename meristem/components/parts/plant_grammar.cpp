// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/plant_grammar.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/expression/expression.h"
#include "meristem/graph/graph.h"
#include "meristem/grow/lsystem/grammar_reader.h"

namespace meristem {

namespace {

constexpr std::size_t kLongestWord = 64;

/// Finds the letters that may follow a ~: the ones that do in the text, and the first letters of their successors.
class PlacedLetters {
 public:
  explicit PlacedLetters(const Grammar& grammar) : grammar_(grammar), is_found_(grammar.alphabet.size()) {
    note(grammar.axiom);
    for (const RuleSet* rules : rule_sets()) {
      for (const GrammarRule& rule : rules->rules) note(rule.successor);
    }
    for (std::size_t k = 0; k < found_.size(); ++k) {
      for (const RuleSet* rules : rule_sets()) {
        for (const std::uint32_t rule : rules->of_letter[found_[k]]) {
          const std::vector<ModuleTemplate>& successor = rules->rules[rule].successor;
          if (!successor.empty()) find(successor.front().letter);
        }
      }
    }
  }

  const std::vector<LetterIndex>& all() const { return found_; }
  bool is_rewritten(LetterIndex letter) const {
    return std::ranges::any_of(rule_sets(), [&](const RuleSet* rules) { return !rules->of_letter[letter].empty(); });
  }

 private:
  std::array<const RuleSet*, 3> rule_sets() const {
    return {&grammar_.production, &grammar_.decomposition, &grammar_.interpretation};
  }

  void note(const std::vector<ModuleTemplate>& word) {
    for (std::size_t k = 0; k + 1 < word.size(); ++k) {
      if (grammar_.alphabet[word[k].letter].symbol == "~") find(word[k + 1].letter);
    }
  }

  void find(LetterIndex letter) {
    if (!is_found_[letter]) found_.push_back(letter);
    is_found_[letter] = true;
  }

  const Grammar& grammar_;
  std::vector<bool> is_found_;
  std::vector<LetterIndex> found_;
};

/// Returns the word after each ~ of the text.
std::vector<std::string_view> words_behind_tildes(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find('~'); at != std::string_view::npos; at = text.find('~', at + 1)) {
    std::size_t begin = at + 1;
    while (begin < text.size() && text[begin] == ' ') ++begin;
    std::size_t end = begin;
    const std::size_t max = std::min(text.size(), begin + kLongestWord);
    while (end < max && is_identifier(text.substr(begin, end + 1 - begin))) ++end;
    words.push_back(text.substr(begin, end - begin));
  }
  return words;
}

void note_placed(PlantGrammar& plant, std::string_view text) {
  const std::vector<std::string_view> words = words_behind_tildes(text);
  const Alphabet& alphabet = plant.grammar.alphabet;
  plant.placed_of_letter.assign(alphabet.size(), kNoIndex);
  const PlacedLetters letters(plant.grammar);
  for (const LetterIndex letter : letters.all()) {
    const std::string& id = alphabet[letter].symbol;
    const auto found = std::ranges::find(plant.placed, id, &PlacedComponent::id);
    plant.placed_of_letter[letter] = static_cast<std::uint32_t>(found - plant.placed.begin());
    if (found == plant.placed.end()) {
      const auto longer = std::ranges::find_if(
          words, [&](std::string_view word) { return word.size() > id.size() && word.starts_with(id); });
      const std::string hint =
          longer == words.end()
              ? ", or longer names among #symbols"
              : fmt::format(", or '#symbols {0}' in the grammar, since '~{0}' is '~{1}' without it", *longer, id);
      plant.placed.push_back({id, !letters.is_rewritten(letter), hint});
    }
  }
}

}  // namespace

PlantGrammar read_plant_grammar(const std::string& text, const std::string& path, ParameterReader& reader,
                                std::vector<Diagnostic>& warnings) {
  const auto included = [&](const std::string& name) {
    return reader.files().included_text(path, name, SizeLimits().document_bytes);
  };
  PlantGrammar plant;
  plant.text = text;
  plant.grammar = read_grammar(text, {.constants = reader.expressions().constants(),
                                      .read = included,
                                      .warnings = &warnings,
                                      .limits = reader.limits()});
  note_placed(plant, text);
  return plant;
}

}  // namespace meristem
