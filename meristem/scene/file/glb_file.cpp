// SPDX-License-Identifier: Apache-2.0
// Reads the two chunks of a GLB file, and checks every access to its JSON and binary data. Based on: see glb_mesh.cpp.
#include "meristem/scene/file/glb_file.h"

#include <bit>
#include <cstring>
#include <utility>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"

namespace meristem {

namespace {

static_assert(std::endian::native == std::endian::little, "the numbers of glTF are read as they lie in the file");

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
// Larger numbers are rejected, so sums and products cannot overflow.
constexpr std::uint64_t kMaxWhole = std::uint64_t{1} << 40;

/// Returns true for extensions that do not change the positions of triangles, or only the type of the stored numbers.
bool is_harmless(const std::string& extension) {
  return extension == "KHR_mesh_quantization" || extension.starts_with("KHR_materials_") ||
         extension.starts_with("KHR_texture_") || extension.starts_with("EXT_texture_") ||
         extension.starts_with("KHR_lights_");
}

template <class T>
T read_as(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

}  // namespace

double GltfNumbers::number(std::uint64_t element, std::uint64_t component) const {
  const char* at = begin + element * stride + component * type_bytes;
  const auto whole = [this](double value, double max) { return is_normalized ? std::max(value / max, -1.0) : value; };
  switch (type) {
    case kGltfInt8:
      return whole(read_as<std::int8_t>(at), 127);
    case kGltfUint8:
      return whole(read_as<std::uint8_t>(at), 255);
    case kGltfInt16:
      return whole(read_as<std::int16_t>(at), 32767);
    case kGltfUint16:
      return whole(read_as<std::uint16_t>(at), 65535);
    case kGltfUint32:
      return read_as<std::uint32_t>(at);
    default:
      return read_as<float>(at);
  }
}

GlbFile::GlbFile(std::string_view bytes, const std::string& file, const SizeLimits& limits) : file_(file) {
  if (bytes.size() < kHeaderBytes + kChunkHeaderBytes) {
    fail("", "the file is cut off in its header", "the whole file");
  }
  if (const auto version = read_as<std::uint32_t>(bytes.data() + 4); version != 2) {
    fail("", fmt::format("the file is of glTF version {}", version), "version 2");
  }
  if (const auto length = read_as<std::uint32_t>(bytes.data() + 8); length > bytes.size()) {
    fail("", fmt::format("the file declares {} bytes, but is cut off after {}", length, bytes.size()),
         "the whole file");
  }
  std::string_view rest = bytes.substr(kHeaderBytes);
  const std::string_view json = take_chunk(rest, kJsonChunk, "JSON");
  if (!rest.empty()) binary_ = take_chunk(rest, kBinaryChunk, "binary");
  parse(json, limits);
  check_extensions();
}

std::string_view GlbFile::take_chunk(std::string_view& rest, std::uint32_t type, const char* name) const {
  if (rest.size() < kChunkHeaderBytes) {
    fail("", fmt::format("the file is cut off before its {} chunk", name), "the whole file");
  }
  const auto length = read_as<std::uint32_t>(rest.data());
  if (read_as<std::uint32_t>(rest.data() + 4) != type) fail("", fmt::format("the file has no {} chunk", name));
  rest.remove_prefix(kChunkHeaderBytes);
  if (length > rest.size()) {
    fail("", fmt::format("the {} chunk declares {} bytes, but {} are left", name, length, rest.size()),
         "the whole file");
  }
  const std::string_view chunk = rest.substr(0, length);
  rest.remove_prefix(std::min<std::size_t>((std::size_t{length} + 3) / 4 * 4, rest.size()));
  return chunk;
}

void GlbFile::parse(std::string_view json, const SizeLimits& limits) {
  if (json.size() > limits.document_bytes) {
    fail("", fmt::format("the JSON of the file has {} bytes", json.size()),
         fmt::format("at most {}", limits.document_bytes));
  }
  try {
    root_ = Json::parse(json);
  } catch (const Json::parse_error& error) {
    fail("", fmt::format("the JSON of the file is broken at its byte {}", error.byte), "valid JSON");
  } catch (const Json::exception&) {
    fail("", "the JSON of the file has a number too large", "finite numbers");
  }
  if (!root_.is_object()) fail("", "the JSON of the file is not an object", "an object");
}

void GlbFile::check_extensions() const {
  for (const Json& extension : list(root_, "extensionsRequired", "")) {
    if (!extension.is_string()) fail("extensionsRequired", "this is not a name", "names of extensions");
    const auto& name = extension.get_ref<const std::string&>();
    if (!is_harmless(name)) {
      fail("", fmt::format("the file cannot be read without the extension {}", in_quotes(name)),
           "a file without compression and instancing");
    }
  }
}

void GlbFile::fail(const std::string& place, std::string message, std::string expected) const {
  if (!place.empty()) message = place + ": " + message;
  throw InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .file = file_});
}

const GlbFile::Json* GlbFile::find(const Json& object, const char* key, const std::string& place) const {
  if (!object.is_object()) fail(place, "this is not an object", "an object");
  const auto found = object.find(key);
  return found != object.end() ? &*found : nullptr;
}

const GlbFile::Json& GlbFile::list(const Json& object, const char* key, const std::string& place) const {
  static const Json kNone = Json::array();
  const Json* found = find(object, key, place);
  if (found == nullptr) return kNone;
  if (!found->is_array()) fail(place, fmt::format("'{}' is not a list", key), "a list");
  return *found;
}

std::optional<std::uint64_t> GlbFile::whole(const Json& object, const char* key, const std::string& place) const {
  const Json* found = find(object, key, place);
  if (found == nullptr) return std::nullopt;
  return as_whole(*found, fmt::format("'{}'", key), place);
}

std::uint64_t GlbFile::as_whole(const Json& value, const std::string& what, const std::string& place) const {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMaxWhole) {
    fail(place, what + " is not a whole number of at least 0, or is too large", fmt::format("0 to {}", kMaxWhole));
  }
  return value.get<std::uint64_t>();
}

const GlbFile::Json& GlbFile::element(const char* key, std::uint64_t index, const std::string& place) const {
  const Json& all = list(root_, key, "");
  if (index >= all.size()) {
    fail(place, fmt::format("there is no {}[{}]", key, index), fmt::format("fewer than {}", all.size()));
  }
  return all[index];
}

GltfNumbers GlbFile::numbers(std::uint64_t accessor, std::string_view type, std::uint64_t components) const {
  // Read the accessor.
  const std::string place = fmt::format("accessors[{}]", accessor);
  const Json& said = element("accessors", accessor, place);
  const Json* given = find(said, "type", place);
  if (given == nullptr || *given != type) fail(place, "the 'type' does not fit", fmt::format("\"{}\"", type));
  if (find(said, "sparse", place) != nullptr) fail(place, "the numbers are sparse", "plain numbers");
  const auto view_index = whole(said, "bufferView", place);
  if (!view_index) fail(place, "the numbers are compressed or left out", "a 'bufferView' in the file itself");
  GltfNumbers result;
  result.count = whole(said, "count", place).value_or(0);
  result.type = whole(said, "componentType", place).value_or(0);
  result.type_bytes = component_bytes(result.type, place);
  if (const Json* normalized = find(said, "normalized", place)) result.is_normalized = *normalized == true;

  // Find the bytes of its view, and check that all of them exist.
  const std::string view_place = fmt::format("bufferViews[{}]", *view_index);
  const Json& view = element("bufferViews", *view_index, place);
  const std::string_view bytes = view_bytes(view, view_place);
  const std::uint64_t element_bytes = components * result.type_bytes;
  result.stride = whole(view, "byteStride", view_place).value_or(element_bytes);
  if (result.stride < element_bytes) {
    fail(view_place, fmt::format("the 'byteStride' {} is too small", result.stride),
         fmt::format("at least {}", element_bytes));
  }
  const std::uint64_t first_end = whole(said, "byteOffset", place).value_or(0) + element_bytes;
  const std::uint64_t room = first_end <= bytes.size() ? (bytes.size() - first_end) / result.stride + 1 : 0;
  if (result.count > room) {
    fail(place, fmt::format("{} elements are declared, but the view has room for {}", result.count, room),
         "elements that the file holds");
  }
  if (result.count > 0) result.begin = bytes.data() + (first_end - element_bytes);
  return result;
}

std::uint64_t GlbFile::component_bytes(std::uint64_t type, const std::string& place) const {
  switch (type) {
    case kGltfInt8:
    case kGltfUint8:
      return 1;
    case kGltfInt16:
    case kGltfUint16:
      return 2;
    case kGltfUint32:
    case kGltfFloat32:
      return 4;
    default:
      fail(place, fmt::format("{} is not a 'componentType'", type), "5120 to 5123, 5125 or 5126");
  }
}

std::string_view GlbFile::view_bytes(const Json& view, const std::string& place) const {
  const std::uint64_t index = whole(view, "buffer", place).value_or(0);
  const Json& buffer = element("buffers", index, place);
  if (index != 0 || find(buffer, "uri", place) != nullptr) {
    fail(fmt::format("buffers[{}]", index), "the bytes are not in the file's own binary chunk",
         "a binary glTF with all of its data");
  }
  const std::uint64_t begin = whole(view, "byteOffset", place).value_or(0);
  const std::uint64_t length = whole(view, "byteLength", place).value_or(0);
  if (begin + length > binary_.size()) {
    fail(place, fmt::format("the view ends at byte {} of {}", begin + length, binary_.size()),
         "a view within the binary chunk");
  }
  return binary_.substr(begin, length);
}

}  // namespace meristem
