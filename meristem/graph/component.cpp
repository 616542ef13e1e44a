// SPDX-License-Identifier: Apache-2.0
// Facts about components that the graph needs: rows that all of them share, fingerprints of their parameters and of
// their growth, and the check of the rules between parameters. A fingerprint covers the component's value, the
// variables that the value names, and the files that were read with it; equal fingerprints allow cached results.
#include "meristem/graph/component.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "meristem/graph/table/fingerprint.h"

namespace meristem {

Frame InstanceTransform::frame() const {
  Frame frame;
  frame.origin = translate;
  if (rotate != Vec3(0)) {
    frame.axes = rotation({0, 0, 1}, rotate.z) * rotation({1, 0, 0}, rotate.x) * rotation({0, 1, 0}, rotate.y);
  }
  for (int k = 0; k < 3; ++k) frame.axes[k] *= scale[k];
  return frame;
}

namespace {

/// Names of the rows of ComponentBase that the growth of a component does not read.
constexpr std::array<std::string_view, 14> kLooks = {
    "colour",  "colours", "colour_at", "variety", "texture", "roughness",           "translucency",
    "opacity", "place",   "omit",      "only",    "hidden",  "omit_keeps_children", "recursion"};

bool is_among(std::string_view name, const auto& names) { return std::ranges::find(names, name) != names.end(); }

const ParameterTable& transform_table() {
  static const ParameterTable table =
      Table<InstanceTransform>("a transform", "A transform: scales first, then turns, then moves.")
          .vector("translate", &InstanceTransform::translate, {.unit = Unit::metre, .min = -1e6, .max = 1e6},
                  "Shift along x (right), y (heading) and z (out of the upper face).")
          .in_space(InSpace::shift)
          .vector("rotate", &InstanceTransform::rotate, {.unit = Unit::degree, .min = -1e6, .max = 1e6},
                  "Angles of pitch about x, roll about y and yaw about z; the roll acts first, then the pitch, then "
                  "the yaw.")
          .in_space(InSpace::turn)
          .vector("scale", &InstanceTransform::scale, {.min = 1e-4, .max = 1e4, .usual = {0.1, 5}},
                  "Scale factors along x, y and z.");
  return table;
}

}  // namespace

const ParameterTable& growing_component_table() {
  static const ParameterTable table =
      Table<GrowingComponent>("a growing component", "Further parameters of components that grow.")
          .boolean(
              "alone", &GrowingComponent::alone,
              "Whether the plant grows in a stand of its own, without competing with the document's other plants.");
  return table;
}

Frame instance_frame(const ComponentBase& base, const Frame& site, Tropism tropism, const Directions& directions) {
  Frame frame = site * base.frame.frame();
  if (tropism == Tropism::none) return frame;
  const auto turn = [&](int column, const FieldPull& pulling, double share) {
    const Vec3 fallback = normalized_or(frame.axes[column == 1 ? 0 : 1], kUp);
    const Vec3 from = normalized_or(frame.axes[column], kUp);
    const double pulled = share_pulled(share, pulling.strength);
    frame.axes = rotation_toward(from, pulling.toward, pulled, fallback) * frame.axes;
  };
  if (base.gravitropism != 0) turn(1, directions.gravity(frame.origin), base.gravitropism);
  if (base.phototropism != 0) {
    turn(tropism == Tropism::face ? 2 : 1, directions.light(frame.origin), base.phototropism);
  }
  return frame;
}

const ParameterTable& component_base_table() {
  static const ParameterTable table =
      Table<ComponentBase>("a component", "Parameters that all components have.")
          .colour("colour", &ComponentBase::colour,
                  "Mean colour of the surface; by default, the component type's own or its picture's.")
          .colours("colours", &ComponentBase::colours,
                   "Colours of the instances, in place of 'colour': each instance has one of them, or a mixture of two "
                   "neighbours.")
          .number(
              "colour_at", &ComponentBase::colour_at, {.min = 0, .max = 1},
              "Position of an instance's colour in 'colours', from the first (0) to the last (1); by default, random.")
          .number("variety", &ComponentBase::variety, {.min = 0, .max = 1, .usual = {0, 0.5}, .fixed = true},
                  "Range over which instances differ in lightness and tone; raised, a more mottled crown.")
          .object("texture", &ComponentBase::texture, texture_table, "Texture of the surface.")
          .number("roughness", &ComponentBase::roughness, {.min = 0, .max = 1, .fixed = true},
                  "Roughness of the surface: 0 is glossy, 1 is matt; by default, the component type's own.")
          .number("translucency", &ComponentBase::translucency, {.min = 0, .max = 1, .fixed = true},
                  "Share of the light that passes through a thin blade; by default, the component type's own.")
          .number(
              "opacity", &ComponentBase::opacity, {.min = 0, .max = 1, .fixed = true},
              "Share of the light that the surface stops, in pictures and glTF; lowered, more of what lies behind is "
              "seen straight through it, as through glass or a thin petal.")
          .object("place", &ComponentBase::place, transform_table,
                  "Transform of this component's own geometry; its children stay where they are.")
          .object("frame", &ComponentBase::frame, transform_table,
                  "Transform of this component's coordinate system, with its geometry and all its children.")
          .number("phototropism", &ComponentBase::phototropism, {.min = -1, .max = 1},
                  "Share of the turn toward the light: of a leaf's upper face, of any other component's heading; "
                  "negative turns away.")
          .number("gravitropism", &ComponentBase::gravitropism, {.min = -1, .max = 1},
                  "Share of the turn of the heading straight down; along stems it acts segment by segment; negative "
                  "turns up.")
          .integer("recursion", &ComponentBase::recursion, {.min = 1, .max = 1000, .usual = {1, 8}, .fixed = true},
                   "Number of instances in a row that a link from a descendant back to this component makes, including "
                   "the first.")
          .selection(
              "omit", &ComponentBase::omit,
              "Instances that are left out: numbers, ranges and conditions over i, n, u and the other site variables.")
          .selection(
              "only", &ComponentBase::only,
              "Instances that are kept: numbers, ranges and conditions over i, n, u and the other site variables.")
          .boolean("omit_keeps_children", &ComponentBase::omit_keeps_children,
                   "Whether the children of an omitted instance stay.")
          .boolean("hidden", &ComponentBase::hidden,
                   "Whether the component's geometry is invisible; its children stay.")
          .never_with("colour", {"colours"})
          .only_with("colours", {"colour_at"})
          .only_where({{"omit"}, {"only"}}, {"omit_keeps_children"});
  return table;
}

const std::vector<std::string>& look_names() {
  static const std::vector<std::string> names = {"colour",    "colours",      "colour_at", "variety", "texture",
                                                 "roughness", "translucency", "opacity",   "place",   "hidden"};
  return names;
}

std::vector<std::string> rows_after_growth(const ComponentType& type) {
  std::vector<std::string> names = type.after_growth;
  for (const std::string_view look : kLooks) {
    if (type.parameters.find(look) != nullptr) names.emplace_back(look);
  }
  return names;
}

namespace {

/// Returns true if an object within this value, at any depth, has a member of that name. Numbers with keys have "keys".
bool has_member(const Value& value, std::string_view name) {
  if (value.find(name) != nullptr) return true;
  if (const Value::List* list = value.list()) {
    return std::ranges::any_of(*list, [&](const Value& one) { return has_member(one, name); });
  }
  const Value::Object* object = value.object();
  return object != nullptr &&
         std::ranges::any_of(*object, [&](const auto& one) { return has_member(one.second, name); });
}

bool asks_for_time(const Value& value) { return mentions(value, "t") || has_member(value, "keys"); }

}  // namespace

void set_fingerprints(Prototype& prototype, const Value& value, const ConstantTable& constants,
                      std::span<const NamedFile> files, const SizeLimits& limits) {
  prototype.fingerprint = fingerprint_of(value, constants, files, limits.file_bytes);
  prototype.depends_on_time = asks_for_time(value) || prototype.type->begins_clock;

  if (!prototype.type->grow || value.object() == nullptr) return;
  Value::Object of_growth = *value.object();
  const std::vector<std::string> after = rows_after_growth(*prototype.type);
  std::erase_if(of_growth, [&](const Value::Member& member) { return is_among(member.first, after); });
  const Value growth(std::move(of_growth));
  prototype.growth_depends_on_time = asks_for_time(growth);
  prototype.growth_fingerprint = fingerprint_of(growth, constants, files, limits.file_bytes);
}

void check_rules(const ComponentType& type, const std::string& id, const void* instance, const SizeLimits& limits) {
  ParameterReader reader({}, limits);
  const DocumentPath top;
  const DocumentPath components(top, "components");
  type.parameters.check_all(instance, DocumentPath(components, id), reader);
  if (reader.error_count() > 0) throw InputError(reader.take_diagnostics());
}

const ComponentType* Registry::find(std::string_view name) const {
  for (const ComponentType& type : types_) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

const ComponentType& Registry::camera() const {
  for (const ComponentType& type : types_) {
    if (type.is_camera) return type;
  }
  throw std::invalid_argument("a registry needs a camera");
}

std::vector<std::string> Registry::names() const {
  std::vector<std::string> names;
  for (const ComponentType& type : types_) names.push_back(type.name);
  return names;
}

}  // namespace meristem
