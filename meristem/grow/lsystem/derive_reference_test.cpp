// SPDX-License-Identifier: Apache-2.0
// Compares derivation with a simple rewriting of strings that finds contexts by walking the word, for random grammars.
#include <gtest/gtest.h>

#include "meristem/grow/lsystem/derive.h"
#include "tests/support/build_grammar.h"

namespace meristem::derive_reference_test {

constexpr std::size_t kNowhere = std::string::npos;

struct PlainRule {
  std::string left;
  char predecessor = ' ';
  std::string right;
  std::string successor;
};

struct PlainGrammar {
  std::string axiom;
  std::string ignored;
  std::vector<PlainRule> rules;
};

bool is_ignored(const PlainGrammar& grammar, char letter) { return grammar.ignored.find(letter) != kNowhere; }

/// Returns the position of the bracket that closes the one at `open`.
std::size_t closing(const std::string& word, std::size_t open) {
  int depth = 0;
  for (std::size_t k = open; k < word.size(); ++k) {
    if (word[k] == '[') ++depth;
    if (word[k] == ']' && --depth == 0) return k;
  }
  return kNowhere;
}

std::size_t left_of(const PlainGrammar& grammar, const std::string& word, std::size_t at) {
  int depth = 0;
  while (at-- > 0) {
    if (word[at] == ']') {
      ++depth;
    } else if (word[at] == '[') {
      if (depth > 0) --depth;
    } else if (depth == 0 && !is_ignored(grammar, word[at])) {
      return at;
    }
  }
  return kNowhere;
}

bool matches_left(const PlainGrammar& grammar, const std::string& word, std::size_t at, const std::string& context) {
  for (std::size_t k = context.size(); k-- > 0;) {
    at = left_of(grammar, word, at);
    if (at == kNowhere || word[at] != context[k]) return false;
  }
  return true;
}

/// Returns true if `context` matches the word from `at` to the end of its axis.
bool matches_right(const PlainGrammar& grammar, const std::string& word, std::size_t at, const std::string& context) {
  if (context.empty()) return true;
  while (at < word.size() && is_ignored(grammar, word[at])) ++at;
  if (at >= word.size() || word[at] == ']') return false;
  if (word[at] != '[') {
    return word[at] == context[0] && matches_right(grammar, word, at + 1, context.substr(1));
  }
  const std::size_t end = closing(word, at);
  if (context[0] == '[') {
    const std::size_t context_end = closing(context, 0);
    if (matches_right(grammar, word, at + 1, context.substr(1, context_end - 1)) &&
        matches_right(grammar, word, end + 1, context.substr(context_end + 1))) {
      return true;
    }
  }
  return matches_right(grammar, word, end + 1, context);
}

std::string rewritten(const PlainGrammar& grammar, const std::string& word) {
  std::string result;
  for (std::size_t k = 0; k < word.size(); ++k) {
    std::string successor(1, word[k]);
    for (const PlainRule& rule : grammar.rules) {
      if (rule.predecessor != word[k] || !matches_left(grammar, word, k, rule.left) ||
          !matches_right(grammar, word, k + 1, rule.right)) {
        continue;
      }
      successor = rule.successor;
      break;
    }
    result += successor;
  }
  return result;
}

/// Generates random strings and rules.
class GrammarDice {
 public:
  explicit GrammarDice(std::uint64_t seed) : key_(seed) {}

  PlainGrammar grammar() {
    PlainGrammar result;
    result.axiom = string(12, true);
    if (below(2) == 0) result.ignored = "+";
    if (below(4) == 0) result.ignored += "a";
    for (std::uint64_t k = 2 + below(6); k > 0; --k) {
      PlainRule rule;
      rule.left = string(below(3), false);
      rule.predecessor = letter();
      rule.right = string(below(5), true);
      rule.successor = string(below(5), true);
      result.rules.push_back(rule);
    }
    return result;
  }

 private:
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(key_.uniform(drawn_++) * static_cast<double>(count));
  }
  char letter() { return "abc+"[below(4)]; }

  /// Returns at least `length` letters, with or without branches.
  std::string string(std::uint64_t length, bool branched) {
    std::string result;
    std::uint64_t depth = 0;
    for (std::uint64_t k = 0; k < length; ++k) {
      if (branched && below(3) == 0) {
        result += '[';
        ++depth;
      }
      result += letter();
      if (depth > 0 && below(2) == 0) {
        result += ']';
        --depth;
      }
    }
    return result + std::string(depth, ']');
  }

  RandomKey key_;
  std::uint64_t drawn_ = 0;
};

TEST(DeriveReference, AgreesWithAPlainRewritingOfRandomGrammars) {
  int changes = 0;
  int context_changes = 0;
  for (std::uint64_t seed = 0; seed < 2'000; ++seed) {
    const PlainGrammar plain = GrammarDice(seed).grammar();
    GrammarText text{plain.axiom, {}, plain.ignored};
    for (const PlainRule& rule : plain.rules) {
      text.rules.push_back(rule.left + "<" + rule.predecessor + ">" + rule.right + "->" + rule.successor);
    }
    const Grammar grammar = build_grammar(text);
    std::string word = plain.axiom;
    for (int step = 1; step <= 5 && word.size() < 3'000; ++step) {
      const std::string before = word;
      word = rewritten(plain, before);
      Progress progress;
      ASSERT_EQ(word_text(derive(grammar, step, RandomKey(), SizeLimits(), progress), grammar.alphabet), word)
          << "seed " << seed << ", step " << step << ", from " << before << " by " << testing::PrintToString(text.rules)
          << " ignoring " << plain.ignored;
      if (word == before) break;
      ++changes;
      if (!plain.rules[0].right.empty()) ++context_changes;
    }
  }
  EXPECT_GT(changes, 2'000);
  EXPECT_GT(context_changes, 500);
}

}  // namespace meristem::derive_reference_test
