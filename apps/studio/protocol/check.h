// SPDX-License-Identifier: Apache-2.0
// Compares values with their forms.
#pragma once

#include <span>
#include <string>

#include "meristem/graph/table/value.h"
#include "protocol/form.h"

namespace meristem::studio {

/// Returns the expected value as text: "a whole number from 16 to 512 (s)".
std::string expectation(const Form& form);

/// Throws a Refusal for the first part of a value that does not have the form. Its message names the path of that part,
/// what is expected there, and for unknown names the nearest valid one.
void check_form(const Form& form, const Value& value, const DocumentPath& path);

/// Like check_form, for the members of an object. `others` are names of members that the caller reads itself.
void check_record(const Record& record, const Value& object, const DocumentPath& path,
                  std::span<const std::string> others = {});

/// Stores the members of a valid object into the struct at `target`, and checks the record's rule. Members that are
/// missing or null keep the struct's defaults. Throws a Refusal.
void store_record(const Record& record, void* target, const Value& object, const DocumentPath& path);

/// Returns the index of the record that identifies a valid object of one of several kinds.
std::size_t kind_index(const Form& form, const Value& object);

/// Returns the text "; did you mean 'name'?", or an empty text if no candidate is similar.
std::string similar(std::string_view name, std::span<const std::string> candidates);

}  // namespace meristem::studio
