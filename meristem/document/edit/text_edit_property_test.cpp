// SPDX-License-Identifier: Apache-2.0
// Random edits of random texts and of the shipped models. The tree of the new text must equal the old tree with the
// same edit in memory, and the inverse patch must restore all bytes.
#include <algorithm>
#include <array>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/document/document.h"
#include "meristem/document/edit/layout.h"
#include "meristem/document/edit/path.h"
#include "meristem/document/edit/text_edit.h"
#include "meristem/document/json.h"

namespace meristem::text_edit_property_test {

/// Whatever a test draws; the same in every run and on every machine.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}

  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool one_in(std::size_t count) { return below(count) == 0; }
  template <class Element, std::size_t n>
  const Element& of(const std::array<Element, n>& elements) {
    return elements[below(n)];
  }

 private:
  std::mt19937_64 engine_;
};

std::string random_name(Draws& draw) {
  static const std::array<std::string, 12> names = {"a",   "b",     "leaf",   "22.5",  "x[0]",      "",
                                                    "\"q", "\\esc", "\u00e9", "// no", "/* nor */", "a.b"};
  return draw.of(names);
}

Value random_value(Draws& draw, int depth) {
  static const std::array<Value, 12> plain = {
      Value(),    Value(true), Value(0),       Value(-2.5),      Value(1e300),        Value(1e-7),
      Value(123), Value(""),   Value("a, b]"), Value("// \"no"), Value("line\nline"), Value("\u00fcber")};
  if (depth == 0 || draw.one_in(3)) return draw.of(plain);
  const std::size_t count = draw.below(4);
  if (draw.one_in(2)) {
    Value::List list;
    for (std::size_t k = 0; k < count; ++k) list.push_back(random_value(draw, depth - 1));
    return list;
  }
  Value::Object object;
  for (std::size_t k = 0; k < count; ++k) {
    std::string name = random_name(draw);
    if (Value(object).find(name) == nullptr) object.emplace_back(std::move(name), random_value(draw, depth - 1));
  }
  return object;
}

/// Writes values in any layout that JSON allows, with comments anywhere.
class WildWriter {
 public:
  explicit WildWriter(Draws& draw) : draw_(draw), line_end_(draw.one_in(3) ? "\r\n" : "\n"), is_tame_(draw.one_in(2)) {}

  std::string text_of(const Value& value) {
    std::string text = draw_.one_in(4) ? "\xEF\xBB\xBF" : "";
    text += blanks(0) + written(value, 0) + blanks(0);
    return text;
  }

 private:
  std::string written(const Value& value, std::size_t depth) {
    const bool is_list = value.list() != nullptr;
    if (!is_list && value.object() == nullptr) return plain(value);
    const std::size_t count = part_count(value);
    const bool in_lines = draw_.one_in(2);
    std::string text = is_list ? "[" : "{";
    for (std::size_t k = 0; k < count; ++k) {
      if (k > 0) text += blanks(depth) + ",";
      text += in_lines ? tail() + line(depth + 1) : draw_.one_in(2) ? " " : "";
      text += blanks(depth + 1);
      if (!is_list) {
        text += write_json_line(Value((*value.object())[k].first)) + blanks(depth) + ":" + blanks(depth) + " ";
      }
      text += written(is_list ? (*value.list())[k] : (*value.object())[k].second, depth + 1);
    }
    text += in_lines ? tail() + line(depth) : blanks(depth);
    return text + (is_list ? "]" : "}");
  }

  std::string plain(const Value& value) {
    if (value.number() != nullptr && *value.number() == 0 && draw_.one_in(2)) return "0.00";
    if (value.number() != nullptr && *value.number() == 123 && draw_.one_in(2)) return "1.23E+2";
    return write_json_line(value);
  }

  std::string line(std::size_t depth) { return line_end_ + std::string(2 * depth, ' '); }
  /// What ends a line.
  std::string tail() { return draw_.one_in(4) ? "  // end" : draw_.one_in(6) ? "  \t" : ""; }
  std::string blanks(std::size_t depth) {
    if (is_tame_ && !draw_.one_in(12)) return "";
    switch (draw_.below(9)) {
      case 0:
        return " ";
      case 1:
        return line(depth);
      case 2:
        return "/* in, \"it\" */";
      case 3:
        return " // to the end }" + line(depth);
      case 4:
        return "/* over" + line(depth) + "lines */";
      case 5:
        return line_end_ + line(depth) + "// above" + line(depth);
      case 6:
        return is_tame_ ? "\t" : "//\r";
      default:
        return "";
    }
  }

  Draws& draw_;
  std::string line_end_;
  bool is_tame_;
};

/// In quotes, so that no name is taken for two, or two for one.
std::string quoted_below(const std::string& path, const std::string& name) {
  return path + "[" + write_json_line(Value(name)) + "]";
}

struct Spot {
  std::string path;
  std::vector<std::size_t> places;
};

/// Every value below the root.
std::vector<Spot> all_spots(const Value& root) {
  std::vector<Spot> spots{{}};
  for (std::size_t k = 0; k < spots.size(); ++k) {
    const Value* at = &root;
    for (const std::size_t place : spots[k].places) {
      at = at->list() != nullptr ? &(*at->list())[place] : &(*at->object())[place].second;
    }
    for (std::size_t part = 0; part < part_count(*at); ++part) {
      Spot spot = spots[k];
      spot.places.push_back(part);
      spot.path = at->list() != nullptr ? spot.path + "[" + std::to_string(part) + "]"
                                        : quoted_below(spot.path, (*at->object())[part].first);
      spots.push_back(std::move(spot));
    }
  }
  spots.erase(spots.begin());
  return spots;
}

Value& value_in(Value& root, const std::vector<std::size_t>& places) {
  Value* at = &root;
  for (const std::size_t place : places) {
    at = at->list() != nullptr ? &(*at->list())[place] : &(*at->object())[place].second;
  }
  return *at;
}

template <class Parts>
void move_part(Parts& parts, std::size_t from, std::size_t to) {
  auto part = std::move(parts[from]);
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(from));
  parts.insert(parts.begin() + static_cast<std::ptrdiff_t>(to), std::move(part));
}

/// A random edit of the text; `expected` is edited in the same way in memory.
TextPatch random_edit(const LocatedTree& tree, Value& expected, Draws& draw) {
  const std::vector<Spot> spots = all_spots(expected);
  const Spot spot = spots[draw.below(spots.size())];
  std::vector<std::size_t> above(spot.places.begin(), spot.places.end() - 1);
  const std::size_t place = spot.places.back();
  Value& target = value_in(expected, spot.places);
  Value& container = value_in(expected, above);
  const std::size_t count = part_count(container);
  const auto at = static_cast<std::ptrdiff_t>(place);
  switch (draw.below(7)) {
    case 0: {
      Value value = random_value(draw, 2);
      TextPatch patch = set_value(tree, spot.path, value);
      target = std::move(value);
      return patch;
    }
    case 1: {  // a value that differs in a part of it
      Value value = target;
      if (Value::List* list = value.list(); list != nullptr && !list->empty()) {
        list->erase(list->begin() + static_cast<std::ptrdiff_t>(draw.below(list->size())));
        list->insert(list->begin() + static_cast<std::ptrdiff_t>(draw.below(list->size() + 1)), draw.below(3), 77);
      } else if (Value::Object* object = value.object();
                 object != nullptr && !object->empty() && value.find("new") == nullptr) {
        object->erase(object->begin() + static_cast<std::ptrdiff_t>(draw.below(object->size())));
        object->insert(object->begin() + static_cast<std::ptrdiff_t>(draw.below(object->size() + 1)), {"new", 77});
      }
      TextPatch patch = set_value(tree, spot.path, value);
      target = std::move(value);
      return patch;
    }
    case 2: {
      TextPatch patch = remove_value(tree, spot.path);
      if (container.list() != nullptr) container.list()->erase(container.list()->begin() + at);
      if (container.object() != nullptr) container.object()->erase(container.object()->begin() + at);
      return patch;
    }
    case 3: {
      const std::size_t to = draw.below(count);
      TextPatch patch = move_value(tree, spot.path, to);
      if (container.list() != nullptr) move_part(*container.list(), place, to);
      if (container.object() != nullptr) move_part(*container.object(), place, to);
      return patch;
    }
    case 4: {
      if (container.object() == nullptr || container.find("other") != nullptr) return {};
      TextPatch patch = rename_member(tree, spot.path, "other");
      (*container.object())[place].first = "other";
      return patch;
    }
    case 5: {  // into the spot's own container
      const Value value = random_value(draw, 2);
      if (container.list() != nullptr) {
        TextPatch patch = insert_value(tree, spot.path, value);
        container.list()->insert(container.list()->begin() + at, value);
        return patch;
      }
      if (container.find("more.") != nullptr) return {};
      const auto around =
          std::find_if(spots.begin(), spots.end(), [&](const Spot& other) { return other.places == above; });
      const std::string in = quoted_below(around == spots.end() ? "" : around->path, "more.");
      TextPatch patch = insert_value(tree, in, value, place);
      container.object()->insert(container.object()->begin() + at, {"more.", value});
      return patch;
    }
    default: {  // behind all that the spot holds
      const Value value = random_value(draw, 2);
      if (target.list() != nullptr) {
        TextPatch patch = insert_value(tree, spot.path + "[]", value);
        target.list()->push_back(value);
        return patch;
      }
      if (target.object() == nullptr || target.find("last") != nullptr) return {};
      TextPatch patch = set_value(tree, quoted_below(spot.path, "last"), value);
      target.object()->emplace_back("last", value);
      return patch;
    }
  }
}

std::size_t comment_count(const std::string& text) { return comments_between(text, 0, text.size()).size(); }

/// A tree after patches must have the values and positions of the tree of its text.
void expect_same_tree(const LocatedTree& one, LocatedValue a, const LocatedTree& other, LocatedValue b) {
  const TextNode& found = one.at(a);
  const TextNode& right = other.at(b);
  ASSERT_EQ(found.begin, right.begin);
  ASSERT_EQ(found.end, right.end);
  ASSERT_EQ(found.name_begin, right.name_begin);
  ASSERT_EQ(found.name_end, right.name_end);
  ASSERT_EQ(found.comma, right.comma);
  ASSERT_EQ(found.parts.size(), right.parts.size());
  ASSERT_EQ(part_count(*a.value), part_count(*b.value));
  for (std::size_t k = 0; k < part_count(*a.value) && !::testing::Test::HasFatalFailure(); ++k) {
    if (a.value->object() != nullptr) {
      ASSERT_EQ(one.index_of(a, (*a.value->object())[k].first), k);
    }
    expect_same_tree(one, one.part(a, k), other, other.part(b, k));
  }
}

void expect_tree_of_its_text(const LocatedTree& tree, const std::string& text) {
  ASSERT_EQ(tree.text(), text);
  const LocatedTree fresh(text);
  ASSERT_TRUE(*tree.root().value == *fresh.root().value);
  expect_same_tree(tree, tree.root(), fresh, fresh.root());
}

/// Some edits in turn, which can be taken back one by one and all together.
void check_edits(const std::string& first, std::uint64_t seed, int edits) {
  Draws draw(seed);
  Value expected = parse_json(first);
  std::string text = first;
  LocatedTree changed(first);
  PatchJoiner joiner;
  TextPatch all;
  for (int k = 0; k < edits && part_count(expected) > 0; ++k) {
    const LocatedTree tree(text);
    const TextPatch patch = random_edit(tree, expected, draw);
    ASSERT_TRUE(is_sound(patch, text.size()));
    const std::string edited = apply_patch(text, patch);
    ASSERT_EQ(write_json(parse_json(edited)), write_json(expected)) << first << "\n--->\n"
                                                                    << text << "\n--->\n"
                                                                    << edited;
    ASSERT_EQ(apply_patch(edited, inverse_patch(text, patch)), text);
    changed.apply(patch);
    ASSERT_NO_FATAL_FAILURE(expect_tree_of_its_text(changed, edited)) << text << "\n--->\n" << edited;
    all = joined_patches(all, patch);
    joiner.add(patch);
    text = edited;
  }
  EXPECT_EQ(joiner.joined(), all);
  EXPECT_EQ(apply_patch(first, all), text);
  EXPECT_EQ(apply_patch(text, inverse_patch(first, all)), first);
}

TEST(TextEditProperty, RandomEditsOfRandomTextsSayWhatTheEditedTreeSaysAndCanBeTakenBack) {
  constexpr std::uint64_t kTexts = 3500;  // three edits each
  for (std::uint64_t seed = 0; seed < kTexts && !::testing::Test::HasFatalFailure(); ++seed) {
    Draws draw(seed);
    Value::Object object{{"first", random_value(draw, 4)}};
    const Value value = draw.one_in(4) ? Value(Value::List{random_value(draw, 4), 1}) : Value(object);
    SCOPED_TRACE(seed);
    check_edits(WildWriter(draw).text_of(value), seed, 3);
  }
}

TEST(TextEditProperty, NumbersAndMembersThatAreSetLeaveAllComments) {
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    Draws draw(seed);
    const Value value(Value::Object{{"first", random_value(draw, 4)}, {"second", 1}});
    const std::string text = WildWriter(draw).text_of(value);
    for (const char* path : {"second", "third", "first"}) {
      const LocatedTree tree(text);
      const PathTarget target = follow_path(tree, path);
      if (target.missing.empty() && part_count(*target.last().value) > 0) continue;
      if (target.missing.empty() &&
          comments_between(text, tree.at(target.last()).begin, tree.at(target.last()).end).size() > 0)
        continue;
      const std::string edited = apply_patch(text, set_value(tree, path, 0.125));
      EXPECT_EQ(comment_count(edited), comment_count(text)) << text << "\n--->\n" << edited;
    }
  }
}

/// Objects with many members are searched by name, and trees forget their shifts after many patches.
TEST(TextEditProperty, ATreeStaysThatOfItsTextThroughThousandsOfEdits) {
  Draws draw(11);
  Value::Object members, element{{"a", 1}, {"b", Value::List{1, 2}}};
  for (int k = 0; k < 200; ++k) members.emplace_back("m" + std::to_string(k), element);
  Value expected(Value::Object{{"many", members}, {"list", Value::List(200, Value(element))}});
  LocatedTree tree(write_json(expected));
  Value::Object& many = *expected.find("many")->object();
  int next = 0;
  const auto path_of = [&](std::size_t k) { return "many." + many[k].first; };
  for (int edit = 0; edit < 3000 && !::testing::Test::HasFatalFailure(); ++edit) {
    const std::size_t k = draw.below(many.size());
    const auto at = many.begin() + static_cast<std::ptrdiff_t>(k);
    switch (draw.below(5)) {
      case 0:
        tree.apply(set_value(tree, path_of(k) + ".a", edit));
        *at->second.find("a") = Value(edit);
        break;
      case 1: {
        const std::string name = "n" + std::to_string(next++);
        tree.apply(insert_value(tree, "many." + name, Value(element), k));
        many.insert(at, {name, Value(element)});
        break;
      }
      case 2:
        tree.apply(remove_value(tree, path_of(k)));
        many.erase(at);
        break;
      case 3: {
        const std::size_t to = draw.below(many.size());
        tree.apply(move_value(tree, path_of(k), to));
        move_part(many, k, to);
        break;
      }
      default: {
        const std::string name = "r" + std::to_string(next++);
        tree.apply(rename_member(tree, path_of(k), name));
        at->first = name;
        break;
      }
    }
    ASSERT_EQ(tree.index_of(tree.part(tree.root(), 0), "m" + std::to_string(edit % 200)) == TextNode::kNone,
              expected.find("many")->find("m" + std::to_string(edit % 200)) == nullptr);
    if (edit % 100 == 99) expect_tree_of_its_text(tree, tree.text());
    ASSERT_TRUE(*tree.root().value == expected);
  }
}

TEST(TextEditProperty, APatchOfPlacesFarApartReadsOnlyTheseParts) {
  Value::Object members;
  for (int k = 0; k < 5000; ++k) members.emplace_back("m" + std::to_string(k), Value::Object{{"a", 1}, {"b", 2}});
  const std::string text = write_json(Value(Value::Object{{"one", members}, {"two", members}}));
  LocatedTree tree(text);
  TextPatch patch;
  for (const char* const path : {"one.m7.a", "one.m4000.b", "two.m1.a", "two.m4999.b"}) {
    for (TextSplice& splice : set_value(tree, path, 12345)) patch.push_back(std::move(splice));
  }
  const std::size_t before = tree.parsed_bytes();
  tree.apply(patch);
  EXPECT_LT(tree.parsed_bytes() - before, 200U);
  expect_tree_of_its_text(tree, apply_patch(text, patch));
}

TEST(TextEditProperty, APatchThatBreaksTheTextIsToldWithItsPlaceInTheWholeText) {
  const std::string text = "{\n  \"a\": [1, 2],\n  \"b\": [1, 2]\n}\n";
  LocatedTree tree(text);
  try {
    tree.apply({{text.rfind('2'), 1, "?"}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].line, 3);
    EXPECT_EQ(error.diagnostics()[0].column, 12);
  }
  LocatedTree other(text);
  EXPECT_THROW(other.apply({{text.find("\"b\""), 3, "\"a\""}, {text.size(), 0, "x"}}), InputError);
  EXPECT_THROW(other.apply({{text.size() + 1, 0, "x"}}), std::invalid_argument);
}

std::vector<std::string> model_texts() {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(MERISTEM_SOURCE_DIR "/models")) {
    if (entry.path().extension() == ".json") texts.push_back(read_text_file(entry.path().string()));
  }
  return texts;
}

TEST(TextEditProperty, ShippedModelsTakeRandomEdits) {
  std::uint64_t seed = 0;
  for (const std::string& text : model_texts()) {
    for (int k = 0; k < 4 && !::testing::Test::HasFatalFailure(); ++k) check_edits(text, ++seed, 4);
  }
}

TEST(TextEditProperty, EveryNumberOfTheShippedModelsIsWrittenOverAlone) {
  for (const std::string& text : model_texts()) {
    const LocatedTree tree(text);
    Value root = *tree.root().value;
    for (const Spot& spot : all_spots(root)) {
      if (value_in(root, spot.places).number() == nullptr) continue;
      const TextPatch patch = set_value(tree, spot.path, 0.0625);
      ASSERT_LE(patch.size(), 1U);
      for (const TextSplice& splice : patch) ASSERT_EQ(splice.replacement, "0.0625") << spot.path;
    }
  }
}

}  // namespace meristem::text_edit_property_test
