// SPDX-License-Identifier: Apache-2.0
// What people would do to the trees of a document now: the operations of their last iteration, found and not done. A
// plan is a growth of a document that says so; these are the values that make one of any document.
#pragma once

#include <string>
#include <vector>

#include "meristem/document/document.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Operations that are planned besides those of the document, as a document lists them.
struct PlanRules {
  std::vector<Value> operations;  ///< operations, each an object
  std::string name = "rules";     ///< what messages call them
};

/// What to read a document's text with, besides all that it was read with, so that the operations of all of its
/// self-organizing trees go on with the rules. A rule acts at the last iteration of a component's trees unless it says
/// when. Throws InputError for rules that are no objects or act in summer, and where no component has such trees.
std::vector<Override> with_rules(const Document& document, const PlanRules& rules);

/// What to read it with so that its trees only plan what the operations of their last iteration, and these rules, would
/// do. The growth of that document tells it by operation_records() and the column `plan_cut`; GrowthView::outcome shows
/// the trees as they would stand after it. Throws as with_rules() does.
std::vector<Override> only_planned(const Document& document, const PlanRules& rules);

}  // namespace meristem
