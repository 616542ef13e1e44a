// SPDX-License-Identifier: Apache-2.0
// What people do to self-organizing trees as they grow. Each kind of operation is a struct of its own, which says when
// it acts and where the document asks for it; what it does to a tree is worked out from the metamers alone, and the
// tree applies it.
#pragma once

#include <string>
#include <variant>

namespace meristem {

/// When an operation acts: after all growth of these iterations.
struct Schedule {
  int at = 1;  ///< iteration, from 1

  bool holds(int iteration) const { return iteration == at; }
  /// The first iteration in which it may act.
  int first() const { return at; }
};

/// A cut just above a bud.
struct Cut {
  Schedule when;
  std::string shoot;  ///< by name: "main.4"
  int above = 0;      ///< metamers of it that stay; 0: it goes whole
  std::string path;   ///< in the document, for errors: "components.apple.operations[3]"
};

/// Every kind has a `when` and a `path`.
using Operation = std::variant<Cut>;

inline const Schedule& schedule_of(const Operation& operation) {
  return std::visit([](const auto& what) -> const Schedule& { return what.when; }, operation);
}
inline const std::string& path_of(const Operation& operation) {
  return std::visit([](const auto& what) -> const std::string& { return what.path; }, operation);
}

}  // namespace meristem
