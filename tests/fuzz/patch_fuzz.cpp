// SPDX-License-Identifier: Apache-2.0
// Fuzzes edits of JSON texts. The first byte selects the edit, the second the place in the tree, the following line is
// a value, and the rest is the text. Valid JSON must stay valid, and the inverse patch must restore the original bytes.
#include <cstddef>
#include <cstdint>
#include <string>

#include "meristem/base/diagnostic.h"
#include "meristem/document/edit/note.h"
#include "meristem/document/edit/plant_part.h"
#include "meristem/document/edit/text_edit.h"
#include "meristem/document/json.h"
#include "tests/fuzz/require.h"

namespace {

using namespace meristem;

/// Returns the path of a part of the tree: at each level the part that `way` selects, until `way` is 0.
std::string chosen_path(const Value& root, std::uint8_t way) {
  std::string path;
  const Value* at = &root;
  while (at->list() != nullptr ? !at->list()->empty() : at->object() != nullptr && !at->object()->empty()) {
    if (const Value::List* list = at->list()) {
      const std::size_t k = way % list->size();
      path += "[" + std::to_string(k) + "]";
      at = &(*list)[k];
    } else {
      const auto& [name, member] = (*at->object())[way % at->object()->size()];
      path += "[" + write_json_line(Value(name)) + "]";
      at = &member;
    }
    way /= 3;
    if (way == 0) break;
  }
  return path;
}

TextPatch edit(const LocatedTree& tree, std::uint8_t kind, const std::string& path, const Value& value) {
  switch (kind % 10) {
    case 0:
      return set_value(tree, path, value);
    case 1:
      return set_value(tree, path + ".new", value);
    case 2:
      return insert_value(tree, path, value);
    case 3:
      return insert_value(tree, path + "[]", value);
    case 4:
      return insert_value(tree, path + ".new", value, kind / 10);
    case 5:
      return remove_value(tree, path);
    case 6:
      return move_value(tree, path, kind / 10);
    case 8:
      return set_note(tree, path, value.text() != nullptr ? *value.text() : "a note\nof two lines");
    case 9: {
      TreeEdit edit(tree);
      insert_plant_part(edit, LocatedTree(write_json(value)), {.component = kind / 20, .link = kind / 20});
      return edit.patch();
    }
    default:
      return rename_member(tree, path, "new");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const std::string all(reinterpret_cast<const char*>(data + 2), size - 2);
  const std::size_t line = all.find('\n');
  if (line == std::string::npos) return 0;
  const std::string text = all.substr(line + 1);
  TextPatch patch;
  try {
    const Value value = parse_json(all.substr(0, line));
    const LocatedTree tree(text);
    patch = edit(tree, data[0], chosen_path(*tree.root().value, data[1]), value);
  } catch (const InputError& error) {
    require(!error.diagnostics().empty() && !error.diagnostics()[0].message.empty());
    return 0;
  }
  require(is_sound(patch, text.size()));
  const std::string edited = apply_patch(text, patch);
  require(apply_patch(edited, inverse_patch(text, patch)) == text);
  if (patch.empty()) return 0;
  LocatedTree changed(text);
  changed.apply(patch);  // an exception ends the fuzzer
  require(changed.text() == edited && *changed.root().value == parse_json(edited));
  return 0;
}
