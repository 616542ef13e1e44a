// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>
#include <vector>

#include "examples.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/grow/lsystem/derive.h"
#include "meristem/grow/lsystem/grammar_reader.h"
#include "meristem/grow/organize/organize.h"
#include "meristem/grow/stand.h"
#include "meristem/measure/tree_form.h"
#include "meristem/scene/crown/crown_points.h"
#include "meristem/scene/crown/solid_crowns.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/mesh/simplify.h"
#include "meristem/shape/solid/primitives.h"
#include "meristem/shape/tube/tubes.h"

using namespace meristem;

namespace {

// Example of Stand: two trees compete for the points of one crown.
void stand() {
  Progress progress;
  const RandomKey key(7);
  const EllipsoidCrown crown({0, 1.5F, 0}, {1, 0.8F, 1});
  const std::vector<Vec3> points = sample_crown(crown, 800, key.child("points"), progress);

  ColonizeParameters parameters;
  parameters.step = 0.08;      // metres
  parameters.influence = 0.6;  // metres
  parameters.kill = 0.2;       // metres
  const Scene open;            // must outlive the growth
  Stand pair;
  Seedling west;
  west.root = {-0.4F, 0, 0};
  west.points = points;
  Seedling east;
  east.root = {0.4F, 0, 0};
  pair.add(make_colonizer(pair, {west}, parameters, key.child(0), open, SizeLimits(), "west", progress));
  pair.add(make_colonizer(pair, {east}, parameters, key.child(1), open, SizeLimits(), "east", progress));
  pair.grow(progress);
  const std::vector<Skeleton> trees = pair.take_skeletons(progress);
  expect(trees.size() == 2 && trees[0].node_count() > 100);
}

// Example of OrganizeParameters: a tree from its buds, after eight years.
void organize() {
  Progress progress;
  OrganizeParameters parameters;
  parameters.iterations = 8;
  parameters.length = 0.12;  // metres for each metamer
  const Scene open;          // must outlive the growth
  Stand stand;
  stand.add(make_organizer(stand, {OrganizeSeed{}}, parameters, RandomKey(3), open, SizeLimits(), "tree"));
  stand.grow(progress);
  const Skeleton tree = std::move(stand.take_skeletons(progress).front());
  expect(tree.axis_count() > 1);
}

// Example of Grammar: a plant by the rules of an L-system.
void grammar() {
  const Grammar rules = read_grammar("#axiom A\n#rules\nA -> F[+A]A\nF -> FF\n");
  Progress progress;
  const Word word = derive(rules, 2, RandomKey(1), SizeLimits(), progress);
  expect(word_text(word, rules.alphabet) == "FF[+F[+A]A]F[+A]A");
}

// Example of SurfaceOptions: a stem as a tube with eight sides.
void surface() {
  Skeleton stem;
  const NodeIndex root = stem.add_node(kNoNode, {0, 0, 0}, 0);
  stem.add_node(root, {0, 1, 0}, 1);
  stem.radius = {0.1F, 0.1F};
  SurfaceOptions bark;
  bark.sides = 8;
  bark.flare = 0;
  Progress progress;
  const Mesh tube = make_tubes(stem, bark, progress);
  expect(tube.triangle_count() > 16 && tube.uvs.size() == tube.vertex_count());
}

// Example of SimplifyTarget: a sphere with a quarter of its triangles.
void simplified() {
  Progress progress;
  Mesh sphere = make_sphere(1, 64);
  sphere.uvs.clear();  // simplified meshes have no texture coordinates
  const Mesh coarse = simplify(sphere, {.triangles = sphere.triangle_count() / 4}, progress);
  expect(coarse.triangle_count() <= sphere.triangle_count() / 4);
}

// Example of TreeForm: the form of a digitised tree.
void tree_form() {
  Skeleton tree;
  const NodeIndex root = tree.add_node(kNoNode, {0, 0, 0}, 0);
  const NodeIndex fork = tree.add_node(root, {0, 2, 0}, 0);
  tree.add_node(fork, {-1, 3, 0}, 0);
  tree.add_node(fork, {1, 3, 0}, 0);
  tree.radius = {0.1F, 0.08F, 0.02F, 0.02F};
  tree.axis = {0, 0, 0, 1};
  tree.order = {0, 0, 0, 1};
  const TreeForm form = measure_form(tree, NodeChildren(tree));
  expect(form.height == 3 && form.crown_width == 2 && form.forks == 1);
}

}  // namespace

void grow_examples() {
  stand();
  organize();
  grammar();
  surface();
  simplified();
  tree_form();
}
