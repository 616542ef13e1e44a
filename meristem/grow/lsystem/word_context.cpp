// SPDX-License-Identifier: Apache-2.0
// Finds the neighbours of all modules in one pass with a stack of brackets, and matches contexts along them. See
// word_context.h.
#include "meristem/grow/lsystem/word_context.h"

#include <algorithm>

namespace meristem {

namespace {

constexpr std::size_t kSightsBetweenChecks = 65'536;

std::uint32_t take_last(std::vector<std::uint32_t>& stack) {
  if (stack.empty()) return kNoModule;
  const std::uint32_t last = stack.back();
  stack.pop_back();
  return last;
}

}  // namespace

ContextNeeds context_needs(const Grammar& grammar, const RuleSet& set) {
  ContextNeeds needs;
  for (const GrammarRule& rule : set.rules) {
    needs.left = needs.left || !rule.left.empty();
    needs.right = needs.right || !rule.right.empty();
    for (const ContextModule& module : rule.right) needs.branches = needs.branches || module.letter == grammar.open;
  }
  return needs;
}

void WordContext::find(const Grammar& grammar, std::span<const LetterIndex> letters, ContextNeeds needs,
                       const Progress& progress) {
  grammar_ = &grammar;
  letters_ = letters;
  if (needs.left) find_left(grammar, progress);
  if (needs.right) find_right(grammar, progress);
  if (needs.branches) find_symbols(grammar, progress);
}

void WordContext::find_left(const Grammar& grammar, const Progress& progress) {
  left_.resize(letters_.size());
  std::vector<std::uint32_t> branches;
  std::uint32_t last = kNoModule;
  for (std::size_t k = 0; k < letters_.size(); ++k) {
    if (k % kSightsBetweenChecks == 0) progress.check();
    const LetterIndex letter = letters_[k];
    left_[k] = last;
    if (letter == grammar.open) {
      branches.push_back(last);
    } else if (letter == grammar.close) {
      last = take_last(branches);
    } else if (grammar.is_ignored[letter] == 0) {
      last = static_cast<std::uint32_t>(k);
    }
  }
}

void WordContext::find_right(const Grammar& grammar, const Progress& progress) {
  right_.resize(letters_.size());
  std::vector<std::uint32_t> after_branches;
  std::uint32_t next = kNoModule;
  for (std::size_t k = letters_.size(); k-- > 0;) {
    if (k % kSightsBetweenChecks == 0) progress.check();
    const LetterIndex letter = letters_[k];
    right_[k] = next;
    if (letter == grammar.close) {
      after_branches.push_back(next);
      next = kNoModule;
    } else if (letter == grammar.open) {
      next = take_last(after_branches);
    } else if (grammar.is_ignored[letter] == 0) {
      next = static_cast<std::uint32_t>(k);
    }
  }
}

void WordContext::find_symbols(const Grammar& grammar, const Progress& progress) {
  symbol_.resize(letters_.size());
  std::vector<std::uint32_t> ends;
  std::uint32_t next = kNoModule;
  for (std::size_t k = letters_.size(); k-- > 0;) {
    if (k % kSightsBetweenChecks == 0) progress.check();
    const LetterIndex letter = letters_[k];
    const bool is_bracket = letter == grammar.open || letter == grammar.close;
    symbol_[k] = letter == grammar.open ? take_last(ends) : next;
    if (letter == grammar.close) ends.push_back(static_cast<std::uint32_t>(k));
    if (is_bracket || grammar.is_ignored[letter] == 0) next = static_cast<std::uint32_t>(k);
  }
}

bool WordContext::matches(const GrammarRule& rule, std::uint32_t position, std::vector<std::uint32_t>& matched) const {
  matched.resize(rule.left.size() + rule.right.size());
  return matches_left(rule, position, matched.data()) &&
         matches_right(rule, position, matched.data() + rule.left.size());
}

bool WordContext::matches_left(const GrammarRule& rule, std::uint32_t position, std::uint32_t* matched) const {
  for (std::size_t k = rule.left.size(); k-- > 0;) {
    position = left_[position];
    if (position == kNoModule || letters_[position] != rule.left[k].letter) return false;
    matched[k] = position;
  }
  return true;
}

bool WordContext::matches_right(const GrammarRule& rule, std::uint32_t position, std::uint32_t* matched) const {
  struct Branch {
    std::size_t in_rule;
    std::uint32_t in_word;
  };
  std::vector<Branch> branches;  // the open branches that contain `position`
  std::size_t k = 0;
  while (k < rule.right.size()) {
    const LetterIndex letter = rule.right[k].letter;
    std::uint32_t next = kNoModule;
    matched[k] = kNoModule;
    if (letter == grammar_->close) {
      // Skip the rest of the branch.
      next = symbol_[branches.back().in_word];
      branches.pop_back();
      if (next == kNoModule) return false;
    } else {
      next = letter == grammar_->open ? next_symbol(position) : right_[position];
      if (next != kNoModule && letters_[next] == letter) {
        if (letter == grammar_->open) branches.push_back({k, next});
        matched[k] = next;
      } else {
        // The innermost open branch is not the rule's branch. Continue after it.
        if (branches.empty()) return false;
        k = branches.back().in_rule;
        position = symbol_[branches.back().in_word];
        branches.pop_back();
        if (position == kNoModule) return false;
        continue;
      }
    }
    position = next;
    ++k;
  }
  return true;
}

std::uint32_t WordContext::next_symbol(std::uint32_t position) const {
  if (letters_[position] != grammar_->open) return symbol_[position];
  const std::uint32_t inside = position + 1;
  if (inside >= letters_.size()) return kNoModule;
  const LetterIndex letter = letters_[inside];
  const bool is_bracket = letter == grammar_->open || letter == grammar_->close;
  return is_bracket || grammar_->is_ignored[letter] == 0 ? inside : symbol_[inside];
}

}  // namespace meristem
