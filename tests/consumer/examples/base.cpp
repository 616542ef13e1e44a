// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "examples.h"
#include "meristem/base/atomic_file.h"
#include "meristem/base/curve.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/expression/expression.h"
#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"
#include "meristem/base/parallel.h"
#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/base/track.h"

using namespace meristem;

namespace {

// Example of Frame: a leaf at the end of a branch that points to the east.
void frame() {
  const Frame branch = frame_along({0, 2, 0}, {1, 0, 0}, kUp);
  const Frame leaf{rotation({0, 0, 1}, radians(90)), {0, 0.5F, 0}};  // in the branch's own coordinates
  const Frame in_world = branch * leaf;
  expect(std::abs(in_world.origin.x - 0.5F) < 1e-6F);
  expect(std::abs(in_world.origin.y - 2) < 1e-6F);
}

// Example of RandomKey: equal keys and indices give equal numbers, in any order and on any thread.
void random_key() {
  const RandomKey leaves = RandomKey(7).child("oak").child("leaves");
  const double third = leaves.uniform(3, 0.07, 0.10);  // a length of the third leaf, metres
  expect(third >= 0.07 && third < 0.10);
  expect(leaves.uniform(3, 0.07, 0.10) == third);
  expect(leaves.uniform(4) != RandomKey(8).child("oak").child("leaves").uniform(4));
}

// Example of Curve: the taper of a stem from base to tip.
void curve() {
  const Curve taper({{0, 1}, {0.5F, 0.7F}, {1, 0.1F}}, CurveKind::linear);
  expect(std::abs(taper(0.25) - 0.85) < 1e-6);
  expect(taper.slope(0.25) < 0);
}

// Example of KeyTrack: a leaf opens in two seconds.
void track() {
  const KeyTrack opening({{.time = 1, .value = 0}, {.time = 3, .value = 90}});
  expect(opening.at(0) == 0);
  expect(opening.at(2) == 45);
  expect(opening.at(9) == 90);
}

// Example of Expression: a formula of a document, with its error.
void expression() {
  const Expression length = Expression::compile("0.4*parent*(1 - u)", {.variables = {"parent", "u"}, .constants = {}});
  const std::vector<double> values{8, 0.25};
  expect(std::abs(length.evaluate(values) - 2.4) < 1e-12);
  try {
    Expression::compile("0.4*parnt", {.variables = {"parent"}, .constants = {}});
    expect(false);
  } catch (const ExpressionError& error) {
    expect(error.details().offset == 4 && error.details().nearest == "parent");
  }
}

// Example of Progress: a call that reports its stages and can be stopped.
void progress() {
  Progress watched([](std::string_view stage, double share) {
    std::printf("%.*s %.0f %%\n", static_cast<int>(stage.size()), stage.data(), 100 * share);
  });
  watched.begin("measuring", 3);
  for (int tree = 0; tree < 3; ++tree) watched.advance();

  watched.cancel();  // usually from another thread, or from a signal handler
  try {
    watched.check();
    expect(false);
  } catch (const Cancelled&) {
    expect(watched.is_cancelled());
  }
}

// Example of ThreadLimit: loops of this thread use one thread, and give the bytes that they give on many.
void thread_limit() {
  std::vector<double> squares(10'000);
  const ThreadLimit one(1);
  expect(thread_count() == 1);
  parallel_for(squares.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) squares[k] = static_cast<double>(k * k);
  });
  expect(squares[99] == 9801);
}

// Example of InputError: it carries all errors of an input, each with its place.
void input_error() {
  try {
    throw InputError(Diagnostic{.message = "'lenght' is not a parameter of a leaf",
                                .nearest = "length",
                                .path = "components.leaf.lenght",
                                .file = "oak.json",
                                .line = 12,
                                .column = 5});
  } catch (const InputError& error) {
    for (const Diagnostic& found : error.diagnostics()) std::puts(found.text().c_str());
    expect(error.diagnostics().size() == 1);
  }
}

// Example of AtomicFile: a file that appears whole, or not at all.
void atomic_file() {
  AtomicFile file("heights.csv");
  file.write("tree,height\n");
  file.write("oak,6.5\n");
  file.commit();  // without this, nothing appears
}

// Example of Mesh: one triangle on the ground, seen from above.
void mesh() {
  Mesh triangle;
  triangle.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};  // metres
  triangle.triangles = {{0, 1, 2}};                        // counter-clockwise from above
  triangle.normals.assign(triangle.vertex_count(), kUp);
  expect(triangle.triangle_count() == 1);
}

}  // namespace

void base_examples() {
  frame();
  random_key();
  curve();
  track();
  expression();
  progress();
  thread_limit();
  input_error();
  atomic_file();
  mesh();
}
