// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/document.h"

#include <string>

#include "examples.h"
#include "meristem/components/registry.h"
#include "meristem/document/edit/session.h"
#include "meristem/document/grow.h"
#include "meristem/document/json.h"
#include "meristem/graph/component.h"
#include "meristem/graph/table/value.h"

using namespace meristem;

namespace {

// Example of Value: a text of JSON as a tree of values.
void value() {
  const Value leaf = parse_json(R"({"type": "leaf", "length": 0.09})");
  expect(*leaf.find("length")->number() == 0.09);
  expect(leaf.find("width") == nullptr);
  expect(write_json_line(leaf) == R"({"type": "leaf", "length": 0.09})");
}

// Example of Registry: the parameters of a leaf.
void registry() {
  const Registry& components = builtin_components();
  expect(components.find("leaf") != nullptr);
  expect(components.find("leef") == nullptr);
}

// Example of Document: a text is read with another height. All its faults are reported at once.
void document() {
  const Document sapling = read_document(kSapling, "sapling.json", builtin_components(),
                                         {.overrides = {parse_override("tall=0.8")}, .seed = 3});
  expect(sapling.variables[0].name == "tall" && sapling.variables[0].value == 0.8);
  try {
    read_document(R"({"meristem": 1, "components": {"leaf": {"type": "leef"}}})", "wrong.json", builtin_components());
    expect(false);
  } catch (const InputError& error) {
    expect(error.diagnostics()[0].nearest == "leaf" && error.diagnostics()[0].line == 1);
  }
}

// Example of GrownDocument: a plant grows, without its meshes.
void grown_document() {
  Progress progress;
  const Document sapling = read_document(kSapling, "sapling.json", builtin_components());
  const GrownDocument grown = grow_document(sapling, progress, {.up_to = GrownPart::plant});
  expect(grown.plant.stems.size() == 1 && grown.plant.organs.size() == 12);
  expect(grown.meshes.meshes.empty());
}

// Example of Session: an edit, its growth, and its undoing. Layout and comments of the text stay.
void session() {
  Session editor(kSapling, "sapling.json", builtin_components());
  editor.edit("components.leaf.length", 0.12);
  Progress progress;
  expect(editor.grow(progress).plant.organs.size() == 12);
  expect(editor.is_good() && editor.undo_count() == 1);
  editor.undo();
  expect(editor.text() == kSapling);
}

}  // namespace

void document_examples() {
  value();
  registry();
  document();
  grown_document();
  session();
}
