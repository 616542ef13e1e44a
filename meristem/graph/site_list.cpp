// SPDX-License-Identifier: Apache-2.0
// A site as words: the fields one after another, and the two pointers as numbers of entries in the chunk, from 1.
#include "meristem/graph/site_list.h"

#include <bit>

namespace meristem {

namespace {

class WordWriter {
 public:
  explicit WordWriter(SiteCodec::Row& row) : next_(row.data()) {}

  template <class Field>
  void operator()(const Field& field) {
    const auto words = std::bit_cast<std::array<std::uint32_t, sizeof(Field) / sizeof(std::uint32_t)>>(field);
    for (const std::uint32_t word : words) *next_++ = word;
  }

 private:
  std::uint32_t* next_;
};

class WordReader {
 public:
  explicit WordReader(const SiteCodec::Row& row) : next_(row.data()) {}

  template <class Field>
  void operator()(Field& field) {
    std::array<std::uint32_t, sizeof(Field) / sizeof(std::uint32_t)> words;
    for (std::uint32_t& word : words) word = *next_++;
    field = std::bit_cast<Field>(words);
  }

 private:
  const std::uint32_t* next_;
};

/// Returns the number of a pointer's entry, from 1, or 0 for null.
template <class Pointer>
std::uint32_t number_of(const Pointer& pointer, std::vector<Pointer>& entries) {
  if (pointer == nullptr) return 0;
  if (entries.empty() || entries.back() != pointer) entries.push_back(pointer);
  return static_cast<std::uint32_t>(entries.size());
}

template <class Pointer>
void set(Pointer& pointer, std::uint32_t number, const std::vector<Pointer>& entries) {
  if (number == 0) {
    pointer.reset();
  } else if (pointer != entries[number - 1]) {
    pointer = entries[number - 1];
  }
}

}  // namespace

std::uint64_t SiteCodec::Side::bytes() const {
  return values.capacity() * sizeof(values[0]) + surroundings.capacity() * sizeof(surroundings[0]);
}

void SiteCodec::encode(const Site& site, Row& row, Side& side) {
  const auto& [frame, key, i, n, u, length, radius, birth, order, depth, stem, node, along, section, surface,
               individual, row_of_table, depths, clock, appeared, part, values, surroundings] = site;
  WordWriter write(row);
  write(frame);
  write(key);
  write(i);
  write(n);
  write(u);
  write(length);
  write(radius);
  write(birth);
  write(std::uint32_t{order} << 16U | depth);
  write(stem);
  write(node);
  write(along);
  write(section);
  write(surface);
  write(individual);
  write(row_of_table);
  write(depths);
  write(clock.start);
  write(clock.speed);
  write(std::uint32_t{clock.is_local});
  write(appeared);
  write(part);
  write(number_of(values, side.values));
  write(number_of(surroundings, side.surroundings));
}

void SiteCodec::decode(const Row& row, const Side& side, Site& site) {
  auto& [frame, key, i, n, u, length, radius, birth, order, depth, stem, node, along, section, surface, individual,
         row_of_table, depths, clock, appeared, part, values, surroundings] = site;
  WordReader read(row);
  std::uint32_t order_and_depth = 0, is_local = 0, number_of_values = 0, number_of_surroundings = 0;
  read(frame);
  read(key);
  read(i);
  read(n);
  read(u);
  read(length);
  read(radius);
  read(birth);
  read(order_and_depth);
  order = static_cast<std::uint16_t>(order_and_depth >> 16U);
  depth = static_cast<std::uint16_t>(order_and_depth);
  read(stem);
  read(node);
  read(along);
  read(section);
  read(surface);
  read(individual);
  read(row_of_table);
  read(depths);
  read(clock.start);
  read(clock.speed);
  read(is_local);
  clock.is_local = is_local != 0;
  read(appeared);
  read(part);
  read(number_of_values);
  set(values, number_of_values, side.values);
  read(number_of_surroundings);
  set(surroundings, number_of_surroundings, side.surroundings);
}

}  // namespace meristem
