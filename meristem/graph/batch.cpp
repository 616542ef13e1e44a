// SPDX-License-Identifier: Apache-2.0
// Hashes of sites, and the memory of results. The fields of a site are packed without gaps, since gaps have undefined
// bytes. Sites are hashed in parallel, and the hash of a list is a hash of these hashes, equal on any number of
// threads.
#include "meristem/graph/batch.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <string_view>

#include "meristem/base/hash.h"
#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kHashedTogether = 4096;

/// The fields one after another, without gaps between them.
class Packed {
 public:
  template <class Field>
  void add(const Field& field) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(Field)>>(field);
    std::copy(bytes.begin(), bytes.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += sizeof(Field);
  }
  std::uint64_t hash() const { return hash64(std::string_view(bytes_.data(), size_)); }

 private:
  std::array<char, sizeof(Site)> bytes_;
  std::size_t size_ = 0;
};

std::uint64_t hash_of_numbers(const std::vector<std::uint64_t>& numbers) {
  return hash64(
      std::string_view(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(std::uint64_t)));
}

template <class Element>
std::uint64_t bytes_of(const std::vector<Element>& elements) {
  return elements.capacity() * sizeof(Element);
}

}  // namespace

std::optional<std::uint64_t> hash_of(const Site& site) {
  const auto& [frame, key, i, n, u, length, radius, birth, order, depth, stem, node, along, section, surface,
               individual, row, depths, clock, appeared, part, values, surroundings] = site;
  if (surroundings != nullptr && surroundings->hash == 0) return std::nullopt;
  Packed packed;
  packed.add(frame.axes);
  packed.add(frame.origin);
  packed.add(key.bits());
  packed.add(i);
  packed.add(n);
  packed.add(u);
  packed.add(length);
  packed.add(radius);
  packed.add(birth);
  packed.add(order);
  packed.add(depth);
  packed.add(stem);
  packed.add(node);
  packed.add(along);
  packed.add(section);
  packed.add(surface.bits());
  packed.add(individual);
  packed.add(row);
  packed.add(depths);
  packed.add(clock.start);
  packed.add(clock.speed);
  packed.add(clock.is_local);
  packed.add(appeared);
  packed.add(part);
  packed.add(values == nullptr ? std::uint64_t{0} : values->hash());
  packed.add(surroundings == nullptr ? std::uint64_t{0} : surroundings->hash);
  return packed.hash();
}

std::optional<std::uint64_t> hash_of(const SiteList& sites) {
  std::vector<std::uint64_t> hashes(sites.size());
  std::atomic<bool> is_known{true};
  parallel_for(sites.size(), kHashedTogether, [&](std::size_t begin, std::size_t end) {
    std::size_t k = begin;
    sites.read(begin, end, [&](const Site& site) {
      const std::optional<std::uint64_t> hash = hash_of(site);
      if (hash)
        hashes[k++] = *hash;
      else
        is_known = false;
    });
  });
  return is_known ? std::optional(hash_of_numbers(hashes)) : std::nullopt;
}

void BatchResult::release_sites() {
  has_sites = false;
  for (Emitted& block : blocks) {
    block.child_sites = SiteList();
    block.branch_sites = SiteList();
    block.named_sites = SiteList();
  }
}

std::uint64_t BatchResult::bytes() const {
  std::uint64_t sum = bytes_without_sites();
  for (const Emitted& block : blocks) {
    sum +=
        block.child_sites.bytes() + block.branch_sites.bytes() + block.named_sites.bytes() + bytes_of(block.site_names);
  }
  return sum;
}

std::uint64_t BatchResult::bytes_without_sites() const {
  std::uint64_t sum = bytes_of(blocks);
  for (const Emitted& block : blocks) {
    sum += bytes_of(block.prototypes) + block.organs.bytes() + bytes_of(block.sections) + bytes_of(block.stems) +
           bytes_of(block.founded) + bytes_of(block.deformed) + bytes_of(block.individuals) + bytes_of(block.plants);
    for (const EmittedStem& stem : block.stems) {
      sum += stem.skeleton.bytes() + (stem.moved != nullptr ? sizeof(Skeleton) + stem.moved->bytes() : 0) +
             bytes_of(stem.root_of_node) + (stem.trimmed != nullptr ? stem.trimmed->bytes() : 0);
    }
  }
  return sum;
}

std::uint64_t GrownBatch::bytes() const {
  std::uint64_t sum = 0;
  for (const Skeleton& skeleton : skeletons) sum += skeleton.bytes();
  for (const auto& trace : traces) sum += trace != nullptr ? trace->bytes() : 0;
  return sum;
}

}  // namespace meristem
