// SPDX-License-Identifier: Apache-2.0
// The sentences of all parameter tables are tooltips, hovers of the schema and the reference page.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/tables.h"
#include "meristem/graph/component.h"
#include "meristem/graph/crown_placement.h"
#include "meristem/graph/link.h"
#include "meristem/graph/placement.h"
#include "tests/support/check_sentence.h"

namespace meristem::sentences_test {

/// Every table that documents are read by, once; tables hold themselves.
void collect(const ParameterTable& table, std::vector<const ParameterTable*>& tables) {
  if (std::find(tables.begin(), tables.end(), &table) != tables.end()) return;
  tables.push_back(&table);
  for (const Parameter& row : table.parameters) {
    if (row.nested != nullptr) collect(row.nested(), tables);
  }
}

std::vector<const ParameterTable*> all_tables(const Registry& registry) {
  std::vector<const ParameterTable*> tables;
  for (const ComponentType& type : registry.types()) collect(type.parameters, tables);
  for (const ParameterTable* table : {&head_table(), &variable_table(), &limits_table(), &link_table(),
                                      &placement_table(), &crown_placement_table()}) {
    collect(*table, tables);
  }
  return tables;
}

TEST(Sentences, EveryParameterIsExplainedByASentenceThatStandsAlone) {
  const Registry& registry = builtin_components();
  const std::vector<const ParameterTable*> tables = all_tables(registry);
  EXPECT_GT(tables.size(), 60U);
  for (const ParameterTable* table : tables) {
    for (const Parameter& row : table->parameters) {
      const std::string error = sentence_error(row.doc);
      EXPECT_TRUE(error.empty()) << table->name << ", '" << row.name << "': the sentence \"" << row.doc << "\" "
                                 << error;
    }
  }
}

TEST(Sentences, EveryTableAndComponentSaysWhatItIs) {
  const Registry& registry = builtin_components();
  for (const ParameterTable* table : all_tables(registry)) {
    EXPECT_EQ(sentence_error(table->doc), "") << table->name << ": \"" << table->doc << '"';
  }
  for (const ComponentType& type : registry.types()) {
    EXPECT_EQ(sentence_error(type.doc), "") << type.name << ": \"" << type.doc << '"';
  }
}

TEST(Sentences, ThatLeanOnOthersAreFoundOut) {
  EXPECT_EQ(sentence_error("Depth of the largest tooth."), "");
  EXPECT_EQ(sentence_error(""), "is empty");
  EXPECT_EQ(sentence_error("Depth of the largest tooth"), "does not end with a full stop");
  EXPECT_EQ(sentence_error("depth of the largest tooth."), "does not begin with a capital");
  EXPECT_EQ(sentence_error("Of the largest."), "names no subject: it opens with 'Of '");
  EXPECT_EQ(sentence_error("Depth, as above."), "has 'as above'");
  EXPECT_EQ(sentence_error("Angle by which the stem bends."), "has 'by which'");
  EXPECT_EQ(sentence_error("Tile of the same kind."), "has 'the same'");
  EXPECT_EQ(sentence_error(std::string(200, 'A') + "."), "is too long for a tooltip");
}

}  // namespace meristem::sentences_test
