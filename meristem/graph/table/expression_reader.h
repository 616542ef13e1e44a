// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/base/expression/expression_scope.h"
#include "meristem/base/name_table.h"
#include "meristem/graph/table/read_errors.h"

namespace meristem {

/// Reads expressions over the document's variables, and knows the names that the expressions of instances may use.
class ExpressionReader {
 public:
  /// `constants` are the document's variables. `errors` must outlive the reader.
  ExpressionReader(std::vector<ExpressionNames::Constant> constants, ReadErrors& errors);

  /// Reads an expression over `variables` and the document's variables. Returns nothing after an error.
  std::optional<Expression> read(const Value& value, const DocumentPath& path, std::span<const std::string> variables);
  /// Collects the paths of all expressions that are read from now on. Null stops the collection.
  void note_expressions(std::vector<std::string>* paths) { paths_ = paths; }

  /// Adds names that the expressions of instances may use besides the site variables. Applies to later reads.
  void add_instance_names(std::span<const std::string> names) { instance_names_.add(names); }
  /// Sets the reason that messages give for a name that cannot be used: "is a column of texts".
  void refuse_instance_name(const std::string& name, std::string reason) { refused_names_[name] = std::move(reason); }
  /// Returns all names that the expressions of instances may use, the site variables first.
  const std::vector<std::string>& instance_names() const { return instance_names_.names(); }

  /// Returns the document's variables.
  const std::vector<ExpressionNames::Constant>& constants() const { return constants_.all(); }
  /// Returns the document's variables with a table of their names.
  const ConstantTable& constant_table() const { return constants_; }
  /// Returns the hash of the document's variables, which is computed once.
  std::uint64_t constants_hash();

 private:
  ReadErrors& errors_;
  ConstantTable constants_;
  std::optional<std::uint64_t> constants_hash_;
  NameTable instance_names_;
  std::map<std::string, std::string, std::less<>> refused_names_;
  std::vector<std::string>* paths_ = nullptr;
};

}  // namespace meristem
