// SPDX-License-Identifier: Apache-2.0
// The heads of scene packets, which meristem/export/packet/scene_packet.h makes.
#include "protocol/common_records.h"
#include "protocol/protocol.h"
#include "protocol/record_table.h"

namespace meristem::studio {

namespace {

constexpr const char* kKeyDoc = "Key of the content, which never changes.";

const Record& packet_picture() {
  static const Record record = WrittenRecord("PacketPicture", "A picture.")
                                   .member("key", forms::text(), kKeyDoc)
                                   .member("type", forms::choice({"image/png", "image/jpeg"}), "Type of the file.")
                                   .member("width", forms::whole(), "Width, pixels.")
                                   .member("height", forms::whole(), "Height, pixels.")
                                   .member("bytes", forms::array(), "The file. v = 0 is its lower edge.");
  return record;
}

const Record& packet_material() {
  static const Record record =
      WrittenRecord("PacketMaterial", "A new or changed material.")
          .member("index", forms::whole(), "Index of the material.")
          .member("name", forms::text(), "Name of the material.")
          .member("colour", forms::vector(), "Linear factor of the texels of its picture, or of white.")
          .member("roughness", forms::number(), "Roughness, 0 to 1.")
          .member("translucency", forms::number(), "Share of light that passes, 0 to 1.")
          .member("opacity", forms::number(), "Share of light that does not pass straight through, 0 to 1.")
          .member("two_sided", forms::flag(), "True: both sides are visible.")
          .member("masked", forms::flag(), "True: the material has holes where alpha is below 0.5.")
          .optional("picture", forms::text(), "Key of its picture. Missing: none.")
          .optional("normals", forms::text(), "Key of its picture of normals. Missing: none.");
  return record;
}

const Record& packet_mesh() {
  static const Record record =
      WrittenRecord("PacketMesh", "A new mesh.")
          .member("key", forms::text(), kKeyDoc)
          .member("vertices", forms::whole(), "Number of vertices.")
          .member("triangles", forms::whole(), "Number of triangles.")
          .member("positions", forms::array(), "Three f32 per vertex, metres.")
          .member("normals", forms::array(), "Four normalised i8 per vertex, the last 0.")
          .optional("tangents", forms::array(), "Four normalised i8 per vertex, w is -1 or 1. For pictures of normals.")
          .optional("uvs", forms::array(), "Two numbers per vertex.")
          .optional("uv_type", forms::choice({"u16", "f32"}), "Type of `uvs`: normalised u16 if all are within 0 to 1.")
          .member("indices", forms::array(), "Three per triangle, counter-clockwise from outside.")
          .member("index_type", forms::choice({"u16", "u32"}), "Type of `indices`.");
  return record;
}

const Record& packet_instances() {
  static const Record record =
      WrittenRecord("PacketInstances", "A new set of instances.")
          .member("key", forms::text(), kKeyDoc)
          .member("count", forms::whole(), "Number of instances.")
          .member("frames", forms::array(),
                  "Twelve f32 per instance: three rows of a 3x4 matrix, x' = r0 . (x, y, z, 1). A frame may be "
                  "mirrored.")
          .optional("tints", forms::array(), "Four normalised u8 per instance, the last 255: shares of `tint_scale`.")
          .optional("tint_scale", forms::vector(), "Linear factor of the colour of the material for a full tint.");
  return record;
}

const Record& packet_batch() {
  static const Record record = WrittenRecord("PacketBatch", "Instances that are drawn, new or changed.")
                                   .member("component", forms::text(), "Id of the component, or path of the obstacle.")
                                   .member("number", forms::whole(), "Number of the batch within the component.")
                                   .member("mesh", forms::text(), "Key of the mesh.")
                                   .member("material", forms::whole(), "Index of the material.")
                                   .member("instances_of", forms::text(), "Key of the set of instances.");
  return record;
}

const Record& packet_skeleton() {
  static const Record record =
      WrittenRecord("PacketSkeleton", "A new skeleton.")
          .member("key", forms::text(), kKeyDoc)
          .member("positions", forms::array(), "Three f32 per node.")
          .member("segments", forms::array(), "Two u32 per segment: its lower and its upper node.")
          .member("orders", forms::array(), "One u8 per node.")
          .member("radii", forms::array(), "One f32 per node, metres.");
  return record;
}

const Record& packet_lamp() {
  static const Record record = WrittenRecord("PacketLamp", "A lamp.")
                                   .member("position", forms::vector({.unit = Unit::metre}), "Position in the world.")
                                   .member("strength", forms::number(), "Strength.");
  return record;
}

const Record& packet_support() {
  static const Record record = WrittenRecord("PacketSupport", "A support, such as a wire.")
                                   .member("name", forms::text(), "Name of the support.")
                                   .member("points", forms::array(), "Three f32 per point.");
  return record;
}

const Record& packet_scene() {
  static const Record record =
      WrittenRecord("PacketScene", "The surroundings of the plants that are no meshes.")
          .member("sun", forms::vector(), "Unit vector to the sun.")
          .member("lamps", forms::list(forms::record(packet_lamp), kMaxNumbers), "Lamps.")
          .member("supports", forms::list(forms::record(packet_support), kMaxNumbers), "Supports.");
  return record;
}

const Record& packet_counts() {
  static const Record record =
      WrittenRecord("PacketCounts", "The size of the whole plant.")
          .member("triangles", forms::whole(), "Number of triangles. An estimate if `share` < 1.")
          .member("instances", forms::whole(), "Number of instances.")
          .member("nodes", forms::whole(), "Number of nodes of skeletons.");
  return record;
}

const Record& packet_removals() {
  const Form keys = forms::list(forms::text(), kMaxNumbers);
  static const Record record =
      WrittenRecord("PacketRemovals", "Content that is removed, after all other members were applied.")
          .optional("batches",
                    forms::list(forms::tuple({{"component", forms::text()}, {"number", forms::whole()}}), kMaxNumbers),
                    "Batches.")
          .optional("meshes", keys, "Keys of meshes.")
          .optional("instances_of", keys, "Keys of sets of instances.")
          .optional("pictures", keys, "Keys of pictures.")
          .optional("skeletons", keys, "Keys of skeletons.")
          .optional("materials", forms::whole(), "Materials from this index on are removed.");
  return record;
}

const Record& packet_head() {
  const auto records = [](RecordFunction record) { return forms::list(forms::record(record), kMaxNumbers); };
  const Form corner = forms::vector({.unit = Unit::metre});
  static const Record record =
      WrittenRecord("PacketHead", "The head of a scene packet.")
          .member("packet", forms::whole(), "Number of the packet, for `shown`. It rises.")
          .member("whole", forms::flag(), "True: everything that was shown before is removed.")
          .member("fit", forms::flag(), "True: the first packet of a document. The camera may be fitted to it.")
          .member("hash", forms::text(), "Hash of the text that the packet shows.")
          .member("draft", forms::flag(), "True: coarser than at rest, while something moves or at first.")
          .member("share", forms::number({.min = 0, .max = 1}),
                  "Share of all triangles that was requested of the meshes.")
          .member("triangles", forms::whole(), "Number of triangles that are shown, of all instances.")
          .member("instances", forms::whole(), "Number of instances that are shown.")
          .member("of", forms::record(packet_counts), "Size of the whole plant.")
          .optional("bounds", forms::tuple({{"low", corner}, {"high", corner}}),
                    "Corners of what is shown. Missing: nothing.")
          .optional("pictures", records(packet_picture), "New pictures.")
          .optional("materials", records(packet_material), "New and changed materials.")
          .optional("meshes", records(packet_mesh), "New meshes.")
          .optional("instances_of", records(packet_instances), "New sets of instances.")
          .optional("batches", records(packet_batch),
                    "Instances that are drawn, new or changed. Component and number name a batch.")
          .optional("skeletons", records(packet_skeleton), "New skeletons.")
          .optional("lines", forms::list(forms::text(), kMaxNumbers),
                    "Keys of all skeletons to draw. Missing: as before.")
          .optional("scene", forms::record(packet_scene), "Surroundings of the plants. Missing: as before.")
          .optional("gone", forms::record(packet_removals), "Content that is removed.");
  return record;
}

}  // namespace

ProtocolGroup packet_messages() {
  return {.name = "packets", .doc = "The heads of scene packets.", .others = {packet_head}};
}

void check_packet_head(const Value& head) { check_record(packet_head(), head, DocumentPath()); }

}  // namespace meristem::studio
