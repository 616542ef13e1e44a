// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "meristem/base/diagnostic.h"

namespace meristem {

/// Limits on what one document may request. Exceeding one throws an InputError that names the parameter to change,
/// before the memory is used. The defaults suit a machine with 8 GB.
struct SizeLimits {
  std::uint64_t document_bytes = 16'000'000;   ///< bytes of the text of one document
  std::uint64_t nesting = 64;                  ///< levels of lists and objects in a document
  std::uint64_t diagnostics = 100;             ///< errors that are reported at once; the others are only counted
  std::uint64_t expression_bytes = 16'384;     ///< bytes of one expression
  std::uint64_t points = 10'000'000;           ///< attraction points
  std::uint64_t nodes = 20'000'000;            ///< skeleton nodes
  std::uint64_t modules = 200'000'000;         ///< modules of an L-system's word, and limit of its parameters
  std::uint64_t instances = 20'000'000;        ///< organs and sites in total
  std::uint64_t triangles = 50'000'000;        ///< triangles, counted after instancing
  std::uint64_t mesh_bytes = 2'000'000'000;    ///< bytes of distinct geometry
  std::uint64_t file_bytes = 1'000'000'000;    ///< bytes of one file that a document names
  std::uint64_t picture_pixels = 64'000'000;   ///< pixels of one picture that a document names
  std::uint64_t texture_pixels = 250'000'000;  ///< pixels of all textures together
};

/// Returns the error for a limit: `wanted` of `what` were requested and `limit` are allowed. `path` is the parameter to
/// change.
Diagnostic limit_diagnostic(std::string_view what, double wanted, std::uint64_t limit, std::string_view limit_name,
                            std::string_view path);
/// Throws limit_diagnostic() as an InputError.
[[noreturn]] void throw_limit(std::string_view what, double wanted, std::uint64_t limit, std::string_view limit_name,
                              std::string_view path);

}  // namespace meristem
