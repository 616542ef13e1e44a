// SPDX-License-Identifier: Apache-2.0
// Plans for the trees of a document: the operations of their last iteration are found but not carried out. A plan is a
// growth of a document whose trees are in plan mode. These functions return the overrides that turn any document into a
// plan.
#pragma once

#include <string>
#include <vector>

#include "meristem/document/document.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Operations to plan in addition to the document's own, in the form of a document's list.
struct PlanRules {
  std::vector<Value> operations;  ///< operations, each an object
  std::string name = "rules";     ///< name of the rules in messages
};

/// Returns the overrides that add the rules to the operations of all self-organizing trees of a document. Other
/// overrides must be kept when the document is read again. A rule without a time acts at the last iteration of a
/// component's trees. Throws InputError for rules that are no objects or act in summer, and if no component has such
/// trees.
std::vector<ValueOverride> with_rules(const Document& document, const PlanRules& rules);

/// Returns the overrides with which the document's trees only plan the operations of their last iteration and these
/// rules. The growth of that document reports the plan by operation_records() and the column `plan_cut`.
/// GrowthView::outcome shows the trees after the plan. Throws as with_rules() does.
std::vector<ValueOverride> only_planned(const Document& document, const PlanRules& rules);

}  // namespace meristem
