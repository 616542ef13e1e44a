// SPDX-License-Identifier: Apache-2.0
// Records that messages of several subjects use.
#pragma once

#include <cstddef>
#include <vector>

#include "meristem/document/document.h"
#include "protocol/form.h"

namespace meristem::studio {

inline constexpr double kMaxSeconds = 1e9;    ///< largest time in a request
inline constexpr double kMaxPosition = 1e6;   ///< largest coordinate in a request, metres
inline constexpr double kMaxIteration = 1e6;  ///< largest iteration, growth step, rank or number of a leaf

inline constexpr std::size_t kMaxNumbers = 1'000'000'000;  ///< maximum size of lists that have no limit of their own

const Record& no_members();       ///< an object without members
const Record& refused_record();   ///< the members of `refused` besides `is` and `re`
const Record& error_record();     ///< an error or warning about a text
const Record& implied_record();   ///< a link that is not in the text
const Record& reading_record();   ///< what the server knows of a text after reading it
const Record& export_camera();    ///< the camera of a picture, read into a CameraOptions
const Record& instance_record();  ///< an instance of a component
Form errors();                    ///< a list of faults

/// Returns the values of an object by their paths, as values that replace others of the document.
std::vector<ValueOverride> overrides_of(const Value::Object& values);

/// The names of jobs in `working` and `failed`.
Form job_name();

}  // namespace meristem::studio
