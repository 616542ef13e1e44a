// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/formats.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/base/version.h"
#include "meristem/output/gltf.h"

namespace meristem {

namespace {

Provenance provenance_of(const Document& document) {
  return {.name = document.name,
          .author = document.author,
          .licence = document.licence,
          .seed = document.graph.seed,
          .version = std::string(version())};
}

constexpr Format kFormats[] = {
    {".glb", "glTF 2.0 binary, for Blender, Godot, three.js and most others",
     [](const Document& document, const GrownDocument& grown, const std::string& path, Progress& progress) {
       write_glb(grown.meshes, path, {.provenance = provenance_of(document)}, progress);
     }},
};

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format& format_of(const std::string& path) {
  if (path == "-") return kFormats[0];
  const std::size_t name = path.find_last_of('/') + 1;
  const std::size_t dot = path.find_last_of('.');
  std::string ending = dot == std::string::npos || dot < name ? "" : path.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(), lower);
  std::vector<std::string> known;
  for (const Format& format : kFormats) {
    if (format.ending == ending) return format;
    known.emplace_back(format.ending);
  }
  throw InputError(Diagnostic{.message = ending.empty()
                                             ? fmt::format("'{}' has no ending that names a format", path)
                                             : fmt::format("'{}' is not a format that can be written", ending),
                              .expected = fmt::format("a file that ends in {}", fmt::join(known, " or ")),
                              .nearest = nearest_name(ending, known)});
}

}  // namespace meristem
