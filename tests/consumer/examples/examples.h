// SPDX-License-Identifier: Apache-2.0
// The examples of the C++ reference. The page of a class shows the body of the function below "// Example of CLASS:
// ...".
#pragma once

#include <source_location>
#include <stdexcept>
#include <string>

/// Throws if an example does not hold what it shows.
inline void expect(bool holds, std::source_location place = std::source_location::current()) {
  if (!holds) {
    throw std::logic_error(std::string(place.file_name()) + ":" + std::to_string(place.line()) + ": does not hold");
  }
}

/// A sapling with 12 leaves, which grows in a few milliseconds.
inline const std::string kSapling = R"({
  "meristem": 1,
  "name": "Sapling",
  "variables": {"tall": {"value": 0.5, "min": 0.2, "max": 2}},
  "components": {
    "stem": {"type": "tree", "length": "tall", "radius": 0.006},
    "leaf": {"type": "leaf", "length": 0.09, "width": 0.04}
  },
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 12, "divergence": 137.508}]
})";

void base_examples();
void plant_examples();
void grow_examples();
void document_examples();
void output_examples();
