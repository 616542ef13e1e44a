// SPDX-License-Identifier: Apache-2.0
// Reads the sections before the entities line by line, and collects all errors before it stops.
#include "meristem/plant/mtg/mtg_header.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace meristem {
namespace {

constexpr std::array<std::string_view, 5> kSections{"CODE", "CLASSES", "DESCRIPTION", "FEATURES", "MTG"};
constexpr std::array<std::string_view, 4> kNumberTypes{"INT", "INTEGER", "REAL", "DOUBLE"};
constexpr std::array<std::string_view, 14> kOtherTypes{
    "STRING",        "ALPHA",    "BOOLEAN",    "DD/MM",  "DD/MM/YY",   "MM/YY",   "DD/MM-TIME",
    "DD/MM/YY-TIME", "GEOMETRY", "APPEARANCE", "OBJECT", "DD/MM/YYYY", "MM/YYYY", "TIME"};

template <class Range>
bool contains(const Range& range, std::string_view text) {
  return std::find(range.begin(), range.end(), text) != range.end();
}

template <class... Ranges>
std::vector<std::string> names_of(const Ranges&... ranges) {
  std::vector<std::string> names;
  (names.insert(names.end(), ranges.begin(), ranges.end()), ...);
  return names;
}

bool is_class_name(std::string_view text) {
  const auto is_letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; };
  return text == "$" || (!text.empty() && std::all_of(text.begin(), text.end(), is_letter));
}

class HeaderReader {
 public:
  HeaderReader(MtgLines& lines, MtgErrors& errors) : lines_(lines), errors_(errors) {
    header_.classes.push_back({"$", 0});
    header_.class_by_name.emplace("$", 0);
  }

  MtgHeader read() {
    MtgLine line;
    std::string_view section;
    while (lines_.next(line)) {
      std::vector<MtgWord> words = line.words();
      if (const auto begun = section_of(words)) {
        section = *begun;
        if (section == "MTG") {
          // Stop here on errors, because they would cause many errors in the entities.
          errors_.throw_if_any();
          return std::move(header_);
        }
        if (section == "CODE") read_form(line, words);
        continue;
      }
      read_row(section, line, words);
    }
    line = {{}, lines_.last_number()};
    errors_.fail(line, 0, {.message = "the file ends without entities", .expected = "a section that begins with MTG:"});
  }

 private:
  /// Returns the section that a line begins. A blank may precede its colon.
  static std::optional<std::string_view> section_of(const std::vector<MtgWord>& words) {
    const std::string_view word = words[0].text;
    if (word == "CODE") return word;
    const bool has_colon = word.ends_with(':') || (words.size() > 1 && words[1].text.starts_with(':'));
    if (!has_colon && words.size() > 1) return {};
    const auto found = std::find(kSections.begin(), kSections.end(), word.substr(0, word.find(':')));
    return found == kSections.end() ? std::nullopt : std::optional(*found);
  }

  void read_form(const MtgLine& line, const std::vector<MtgWord>& words) {
    const MtgWord form = words.back();
    if (form.text.ends_with("FORM-A")) return;
    errors_.add(line, form.offset,
                {.message = fmt::format("{} is not a form that can be read", shown(form.text)), .expected = "FORM-A"});
  }

  void read_row(std::string_view section, const MtgLine& line, const std::vector<MtgWord>& words) {
    if (section == "CLASSES") {
      if (words[0].text != "SYMBOL") read_class(line, words);
    } else if (section == "DESCRIPTION") {
      // Do not check rules if a class could not be read: they may name it.
      if (words[0].text != "LEFT" && classes_are_known_) check_rule(line, words);
    } else if (section == "FEATURES") {
      if (words[0].text != "NAME") read_feature(line, words);
    } else {
      std::string_view name = words[0].text;
      if (name.ends_with(':')) name.remove_suffix(1);
      errors_.fail(line, words[0].offset,
                   {.message = fmt::format("{} is not a section", shown(words[0].text)),
                    .expected = fmt::format("one of {}", fmt::join(kSections, ", ")),
                    .nearest = nearest_name(name, names_of(kSections))});
    }
  }

  void read_class(const MtgLine& line, const std::vector<MtgWord>& words) {
    const std::string_view name = words[0].text;
    if (!is_class_name(name)) {
      classes_are_known_ = false;
      errors_.add(line, words[0].offset,
                  {.message = fmt::format("{} cannot be a class", shown(name)), .expected = "letters alone"});
      return;
    }
    const auto scale = words.size() > 1 ? to_number(words[1].text) : std::nullopt;
    if (!scale || *scale != static_cast<int>(std::clamp(*scale, 0.0, double{kDeepestMtgScale}))) {
      classes_are_known_ = false;
      errors_.add(line, words.size() > 1 ? words[1].offset : line.text.size(),
                  {.message = fmt::format("the class {} has no scale", shown(name)),
                   .expected = fmt::format("a whole number from 0 to {}", kDeepestMtgScale)});
      return;
    }
    const MtgClass declared{std::string(name), static_cast<int>(*scale)};
    const auto [found, is_new] =
        header_.class_by_name.try_emplace(declared.name, static_cast<std::uint32_t>(header_.classes.size()));
    if (is_new) {
      header_.classes.push_back(declared);
    } else if (header_.classes[found->second].scale != declared.scale) {
      errors_.add(line, words[1].offset,
                  {.message = fmt::format("the class {} has two scales", shown(name)),
                   .expected = fmt::format("{} again", header_.classes[found->second].scale)});
    }
  }

  /// Checks a rule: LEFT, RIGHT (classes with commas), relation, number.
  void check_rule(const MtgLine& line, const std::vector<MtgWord>& words) {
    for (const MtgWord& word : words) {
      if (word.text == "<" || word.text == "+" || word.text == "/") return;
      for (std::size_t begin = 0; begin <= word.text.size();) {
        const std::size_t end = std::min(word.text.find(',', begin), word.text.size());
        const std::string_view name = word.text.substr(begin, end - begin);
        if (!name.empty() && !header_.class_by_name.contains(name)) add_unknown_class(line, word.offset + begin, name);
        begin = end + 1;
      }
    }
    errors_.add(line, line.text.size(), {.message = "the rule has no relation", .expected = "'<' or '+'"});
  }

  void add_unknown_class(const MtgLine& line, std::size_t offset, std::string_view name) {
    errors_.add(line, offset,
                {.message = fmt::format("{} is not a class", shown(name)),
                 .expected = "one that CLASSES declares",
                 .nearest = nearest_known(name, header_.class_by_name)});
  }

  void read_feature(const MtgLine& line, const std::vector<MtgWord>& words) {
    const std::string_view name = words[0].text;
    const std::string_view type = words.size() > 1 ? words[1].text : std::string_view();
    const bool is_number = contains(kNumberTypes, type);
    if (!is_number && !contains(kOtherTypes, type)) {
      errors_.add(
          line, words.size() > 1 ? words[1].offset : line.text.size(),
          {.message = type.empty() ? fmt::format("the feature {} has no type", shown(name))
                                   : fmt::format("{} is not a type of features", shown(type)),
           .expected = fmt::format("one of {}, {}", fmt::join(kNumberTypes, ", "), fmt::join(kOtherTypes, ", ")),
           .nearest = nearest_name(type, names_of(kNumberTypes, kOtherTypes))});
      return;
    }
    const auto number = static_cast<std::uint32_t>(header_.features.size());
    if (header_.feature_by_name.try_emplace(std::string(name), number).second) {
      header_.features.push_back({std::string(name), std::string(type), is_number});
    } else {
      errors_.add(line, words[0].offset,
                  {.message = fmt::format("the feature {} is declared twice", shown(name)), .expected = "it once"});
    }
  }

  MtgLines& lines_;
  MtgErrors& errors_;
  MtgHeader header_;
  bool classes_are_known_ = true;
};

}  // namespace

MtgHeader read_mtg_header(MtgLines& lines, MtgErrors& errors) { return HeaderReader(lines, errors).read(); }

}  // namespace meristem
