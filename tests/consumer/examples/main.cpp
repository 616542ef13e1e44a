// SPDX-License-Identifier: Apache-2.0
// Runs the examples of the C++ reference.
#include "examples.h"

int main() {
  base_examples();
  plant_examples();
  grow_examples();
  document_examples();
  output_examples();
}
