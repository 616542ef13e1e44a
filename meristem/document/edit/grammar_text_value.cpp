// SPDX-License-Identifier: Apache-2.0
// Renames words of a grammar within a document. The grammar is parsed for its words, renamed as plain text, and parsed
// again: the rename is refused if the words then differ in more than the name. Splices are mapped to the lines of the
// document.
#include "meristem/document/edit/grammar_text_value.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/document/edit/part_edit.h"
#include "meristem/document/locate.h"
#include "meristem/document/mentions.h"

namespace meristem {

namespace {

constexpr std::string_view kDeclaration = "#symbols";

/// Returns the words of a grammar, read without the document's variables and files.
GrammarWords words_of(const std::string& text) {
  GrammarWords words;
  GrammarOptions options;
  options.words = &words;
  options.limits.diagnostics = text.size() + 1;
  try {
    read_grammar(text, options);
  } catch (const InputError&) {
    // Unknown names are unimportant here, and faults of form are reported elsewhere.
  }
  return words;
}

std::vector<std::string> renamed(const std::vector<GrammarWord>& words, const std::string& from,
                                 const std::string& to) {
  std::vector<std::string> texts;
  for (const GrammarWord& word : words) texts.push_back(word.text == from ? to : word.text);
  return texts;
}

[[noreturn]] void refuse_symbol(const std::string& path, const std::string& name) {
  throw InputError(Diagnostic{.message = fmt::format("'{}' would have another meaning in the grammar", name),
                              .expected = "another name",
                              .path = path});
}

}  // namespace

GrammarInDocument::GrammarInDocument(const LocatedTree& tree, LocatedValue value) : tree_(tree), value_(value) {
  const auto add = [&](LocatedValue line) {
    if (line.value->text() == nullptr) return;
    lines_.push_back({text_.size(), places_of_bytes(tree.text(), tree.at(line).begin)});
    text_ += *line.value->text();
  };
  if (value.value->list() == nullptr) {
    add(value);
  } else {
    for (std::size_t k = 0; k < part_count(*value.value); ++k) {
      add(tree.part(value, k));
      text_ += '\n';
    }
  }
  words_ = words_of(text_);
}

bool GrammarInDocument::has_symbol(const std::string& symbol) const {
  return std::any_of(words_.symbols.begin(), words_.symbols.end(),
                     [&](const GrammarWord& word) { return word.text == symbol; });
}

bool GrammarInDocument::places(const std::string& symbol) const {
  for (std::size_t k = 0; k + 1 < words_.symbols.size(); ++k) {
    if (words_.symbols[k].text == "~" && words_.symbols[k + 1].text == symbol) return true;
  }
  return false;
}

/// Converts splices of the grammar's text into splices of the document. A splice must not cross the end of a line.
TextPatch GrammarInDocument::in_document(const TextPatch& patch) const {
  TextPatch made;
  for (const TextSplice& splice : patch) {
    const auto after = std::upper_bound(lines_.begin(), lines_.end(), splice.offset,
                                        [](std::size_t offset, const Line& line) { return offset < line.begin; });
    const Line& line = *std::prev(after);
    const std::size_t begin = line.places[splice.offset - line.begin];
    made.push_back({begin, line.places[splice.offset + splice.length - line.begin] - begin, splice.replacement});
  }
  return made;
}

/// Adds the new name to #symbols or removes the old one, if one of them has a single character.
void GrammarInDocument::declare(const std::string& symbol, const std::string& name, TextPatch& patch) const {
  const auto stands_in_declaration = [&](const GrammarWord& word) {
    const std::size_t line = word.offset == 0 ? 0 : text_.rfind('\n', word.offset - 1) + 1;
    const std::size_t begin = text_.find_first_not_of(" \t", line);
    return std::string_view(text_).substr(begin).starts_with(kDeclaration);
  };
  if (name.size() == 1) {
    for (TextSplice& splice : patch) {
      if (!stands_in_declaration({splice.offset, symbol})) continue;
      splice.replacement.clear();
      // A declaration without names would be a fault.
      const std::size_t end = std::min(text_.find('\n', splice.offset), text_.size());
      const std::size_t line = text_.rfind(kDeclaration, splice.offset);
      const std::string_view before = std::string_view(text_).substr(line, splice.offset - line);
      const std::size_t behind = splice.offset + splice.length;
      const bool is_alone =
          before.find_first_not_of(" \t", kDeclaration.size()) == std::string_view::npos &&
          std::string_view(text_).substr(behind, end - behind).find_first_not_of(" \t\r") == std::string_view::npos;
      if (is_alone) splice = {line, behind - line, ""};
    }
  }
}

TextPatch GrammarInDocument::with_symbol(const std::string& symbol, const std::string& name,
                                         const std::string& path) const {
  TextPatch patch;
  for (const GrammarWord& word : words_.symbols) {
    if (word.text != symbol) continue;
    const std::size_t end = word.offset + symbol.size();
    const bool touches_before = word.offset > 0 && is_of_name(text_[word.offset - 1]);
    const bool touches_behind = end < text_.size() && is_of_name(text_[end]);
    patch.push_back({word.offset, symbol.size(), (touches_before ? " " : "") + name + (touches_behind ? " " : "")});
  }
  declare(symbol, name, patch);
  const bool declares = name.size() > 1 && symbol.size() == 1;
  const std::string declaration = fmt::format("{} {}", kDeclaration, name);
  const std::string changed = (declares ? declaration + "\n" : "") + apply_patch(text_, patch);

  // The words must be equal except for the name; otherwise the name cannot be used.
  std::vector<std::string> expected = renamed(words_.symbols, symbol, name);
  std::vector<std::string> found = renamed(words_of(changed).symbols, name, name);
  if (declares) expected.insert(expected.begin(), name);
  if (name.size() == 1 && symbol.size() > 1) {
    // A removed declaration is missing once.
    const auto count = [&](const std::vector<std::string>& words) {
      return std::count(words.begin(), words.end(), name);
    };
    for (auto more = count(expected) - count(found); more > 0; --more) {
      expected.erase(std::find(expected.begin(), expected.end(), name));
    }
  }
  if (has_symbol(name) || found != expected) refuse_symbol(path, name);

  TextPatch made = in_document(patch);
  if (!declares) return made;
  const Value line(declaration);
  TextPatch first;
  if (value_.value->list() != nullptr) {
    first = insert_part(tree_, value_, 0, {.value = &line});
  } else {
    first = {{tree_.at(value_).begin + 1, 0, declaration + "\\n"}};
  }
  made.insert(made.begin(), first.begin(), first.end());
  std::stable_sort(made.begin(), made.end(),
                   [](const TextSplice& a, const TextSplice& b) { return a.offset < b.offset; });
  return made;
}

TextPatch GrammarInDocument::with_name(const std::string& constant, const std::string& name,
                                       const std::string& path) const {
  TextPatch patch;
  for (const GrammarWord& word : words_.names) {
    if (word.text == constant) patch.push_back({word.offset, constant.size(), name});
    if (word.text == name) refuse_symbol(path, name);
  }
  if (patch.empty()) return patch;
  const std::vector<std::string> found = renamed(words_of(apply_patch(text_, patch)).names, name, name);
  if (found != renamed(words_.names, constant, name)) refuse_symbol(path, name);
  return in_document(patch);
}

}  // namespace meristem
