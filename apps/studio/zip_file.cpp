// SPDX-License-Identifier: Apache-2.0
// Based on: PKWARE, APPNOTE.TXT 6.3.10, sections 4.3.7 (local header), 4.3.12 (directory), 4.3.16 (its end); method 0,
// stored. Not supported: sizes of 64 bits, folders, and times (all files are dated 1980-01-01).
#include "zip_file.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>

#include <fmt/format.h>
#include <zlib.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"

namespace meristem::studio {

namespace {

constexpr std::uint16_t kVersion = 10;      // 1.0, the lowest version that reads stored files
constexpr std::uint16_t kUtf8 = 1U << 11U;  // encoding of names
constexpr std::uint16_t kFirstDay = 0x21;   // 1980-01-01
constexpr std::size_t kBlock = 1U << 18U;   // bytes read at a time
constexpr std::uint64_t kMax = std::numeric_limits<std::uint32_t>::max();

struct Entry {
  std::string path;
  std::string name;
  std::uint32_t checksum = 0;
  std::uint32_t size = 0;
  std::uint32_t at = 0;  // position of its local header
};

std::uint32_t small_size(std::uint64_t size) {
  if (size >= kMax) throw MachineError("the files are too large for one archive, which holds less than 4 GB");
  return static_cast<std::uint32_t>(size);
}

/// Calls `take` with the file's bytes, block by block. Returns the sum of their sizes.
template <class Take>
std::uint64_t read_blocks(const std::string& path, const Progress& progress, Take take) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (file == nullptr) throw MachineError(fmt::format("cannot read '{}'", path));
  std::vector<unsigned char> block(kBlock);
  std::uint64_t size = 0;
  while (const std::size_t read = std::fread(block.data(), 1, block.size(), file.get())) {
    progress.check();
    take(block.data(), read);
    size += read;
  }
  if (std::ferror(file.get()) != 0) throw MachineError(fmt::format("cannot read '{}'", path));
  return size;
}

/// A sequence of little-endian numbers.
class Record {
 public:
  Record& two(std::uint16_t number) { return add(number, 2); }
  Record& four(std::uint32_t number) { return add(number, 4); }
  Record& text(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  Record& add(std::uint32_t number, int bytes) {
    for (int k = 0; k < bytes; ++k) bytes_ += static_cast<char>(number >> (8 * k) & 0xffU);
    return *this;
  }
  std::string bytes_;
};

/// Adds the facts that the local header and the directory have in common.
void add_facts(const Entry& entry, Record& record) {
  record.two(kVersion).two(kUtf8).two(0).two(0).two(kFirstDay);
  record.four(entry.checksum).four(entry.size).four(entry.size);
  record.two(static_cast<std::uint16_t>(entry.name.size())).two(0);
}

Entry entry_of(const std::string& path, const Progress& progress) {
  Entry entry{.path = path, .name = std::filesystem::path(path).filename().string()};
  uLong checksum = crc32(0, nullptr, 0);
  entry.size = small_size(read_blocks(path, progress, [&checksum](const unsigned char* data, std::size_t size) {
    checksum = crc32(checksum, data, static_cast<uInt>(size));
  }));
  entry.checksum = static_cast<std::uint32_t>(checksum);
  return entry;
}

}  // namespace

void write_zip(const std::vector<std::string>& files, const std::string& path, const Progress& progress) {
  std::vector<Entry> entries;
  for (const std::string& file : files) entries.push_back(entry_of(file, progress));
  AtomicFile archive(path);
  for (Entry& entry : entries) {
    entry.at = small_size(archive.size());
    Record header;
    add_facts(entry, header.four(0x04034b50));
    archive.write(header.text(entry.name).bytes());
    read_blocks(entry.path, progress,
                [&archive](const unsigned char* data, std::size_t size) { archive.write(data, size); });
  }
  Record directory;
  for (const Entry& entry : entries) {
    directory.four(0x02014b50).two(kVersion);
    add_facts(entry, directory);
    directory.two(0).two(0).two(0).four(0).four(entry.at).text(entry.name);
  }
  const auto count = static_cast<std::uint16_t>(entries.size());
  const std::uint32_t begin = small_size(archive.size());
  const std::uint32_t size = small_size(directory.bytes().size());
  directory.four(0x06054b50).two(0).two(0).two(count).two(count).four(size).four(begin).two(0);
  archive.write(directory.bytes());
  small_size(archive.size());
  archive.commit();
}

}  // namespace meristem::studio
