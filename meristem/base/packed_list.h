// SPDX-License-Identifier: Apache-2.0
// A list that takes less memory than a vector if many fields of neighbouring items are equal. Items are encoded as rows
// of 32-bit words, and rows are stored in chunks. A word that is equal in all rows of a chunk is stored once.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace meristem {

/// Rows of `kWidth` words, with words that are equal in all rows stored once. Rows cannot be changed.
template <std::size_t kWidth>
class PackedRows {
 public:
  static_assert(kWidth <= 64);
  using Row = std::array<std::uint32_t, kWidth>;  ///< an item in words

  /// Packs at least one row.
  explicit PackedRows(std::span<const Row> rows) : count_(static_cast<std::uint32_t>(rows.size())) {
    Row difference{};
    for (const Row& row : rows) {
      for (std::size_t w = 0; w < kWidth; ++w) difference[w] |= row[w] ^ rows[0][w];
    }
    std::array<std::uint8_t, kWidth> varying;
    for (std::size_t w = 0; w < kWidth; ++w) {
      if (difference[w] == 0) continue;
      varying[varying_++] = static_cast<std::uint8_t>(w);
      mask_ |= std::uint64_t{1} << w;
    }
    words_ = std::make_unique_for_overwrite<std::uint32_t[]>(word_count());
    std::copy(rows[0].begin(), rows[0].end(), words_.get());
    std::uint32_t* next = words_.get() + kWidth;
    for (const Row& row : rows) {
      for (std::uint32_t v = 0; v < varying_; ++v) *next++ = row[varying[v]];
    }
  }

  std::size_t count() const { return count_; }  ///< number of rows
  /// Returns the heap memory, bytes.
  std::uint64_t bytes() const { return word_count() * sizeof(std::uint32_t); }

  /// Calls `receive(row)` for the rows from `begin` to before `end`, in their order. All calls get the same object.
  template <class Receive>
  void read(std::size_t begin, std::size_t end, const Receive& receive) const {
    Row row;
    std::copy(words_.get(), words_.get() + kWidth, row.begin());
    std::array<std::uint8_t, kWidth> varying;
    std::uint32_t found = 0;
    for (std::size_t w = 0; w < kWidth; ++w) {
      if ((mask_ >> w & 1U) != 0) varying[found++] = static_cast<std::uint8_t>(w);
    }
    const std::uint32_t* next = words_.get() + kWidth + begin * varying_;
    for (std::size_t k = begin; k < end; ++k) {
      for (std::uint32_t v = 0; v < varying_; ++v) row[varying[v]] = *next++;
      receive(std::as_const(row));
    }
  }

 private:
  std::size_t word_count() const { return kWidth + std::size_t{count_} * varying_; }

  std::unique_ptr<std::uint32_t[]> words_;  // the first row, then the varying words of each row
  std::uint64_t mask_ = 0;                  // bit w: word w varies
  std::uint32_t count_ = 0;
  std::uint32_t varying_ = 0;  // number of words that vary
};

/// A list of items in packed form, except the items added last.
///
/// `Codec` describes how an item becomes a row: `kWidth` is the number of words, `Side` keeps parts of a chunk's items
/// that are no numbers, `encode(item, row, side)` writes a row, and `decode(row, side, item)` sets all fields of an
/// item. `Side` has a function `bytes()`. Up to `kOpen` items at the end of a list are not packed. Items that may still
/// change should be among them: a change of packed items costs as much as adding them again.
template <class Item, class Codec>
class PackedList {
 public:
  static constexpr std::size_t kTogether = 256;  ///< maximum number of items in a chunk

  std::size_t size() const { return packed_ + tail_.size(); }  ///< number of items
  bool empty() const { return size() == 0; }                   ///< true without items
  /// Returns the heap memory, bytes.
  std::uint64_t bytes() const {
    std::uint64_t sum = chunks_.capacity() * sizeof(Chunk) + tail_.capacity() * sizeof(Item);
    for (const Chunk& chunk : chunks_) sum += chunk.rows.bytes() + chunk.side.bytes();
    return sum;
  }

  /// Appends an item and returns it. The reference is valid until the next call of a function that is not const.
  Item& add(const Item& item) {
    if (tail_.size() == Codec::kOpen) pack_first(tail_.size());
    return tail_.emplace_back(item);
  }
  /// Returns the item that was added last. Not valid after pack().
  Item& back() {
    assert(!tail_.empty());
    return tail_.back();
  }

  /// Packs all items but the last few, which make no whole chunk.
  void pack_chunks() {
    if (tail_.size() >= kTogether) pack_first(tail_.size() / kTogether * kTogether);
  }
  /// Packs all items and frees the memory that they took before. Call it when the list is complete.
  void pack() {
    pack_first(tail_.size());
    tail_ = std::vector<Item>();
    chunks_.shrink_to_fit();
  }

  /// Appends the items of another list. Full chunks are moved and not copied.
  void append(PackedList more) {
    for (Chunk& chunk : more.chunks_) {
      const std::size_t count = chunk.rows.count();
      if (2 * count <= kTogether || tail_.size() + count <= kTogether) {
        decode(chunk, 0, count, [&](const Item& item) { add(item); });
        pack_chunks();
      } else {
        pack_first(tail_.size());
        chunk.begin = packed_;
        packed_ += count;
        chunks_.push_back(std::move(chunk));
      }
    }
    for (const Item& item : more.tail_) add(item);
  }

  /// Calls `receive(item)` for the items from `begin` to before `end`, in their order.
  template <class Receive>
  void read(std::size_t begin, std::size_t end, const Receive& receive) const {
    if (begin >= end) return;
    for (auto chunk = chunk_of(begin); chunk != chunks_.end() && chunk->begin < end; ++chunk) {
      const std::size_t last = std::min(end - chunk->begin, chunk->rows.count());
      decode(*chunk, std::max(begin, chunk->begin) - chunk->begin, last, receive);
    }
    for (std::size_t k = std::max(begin, packed_); k < end; ++k) receive(tail_[k - packed_]);
  }
  /// Calls `receive(item)` for all items in their order.
  template <class Receive>
  void read(const Receive& receive) const {
    read(0, size(), receive);
  }
  /// Calls `receive(item)` for all items in their order, and frees each chunk after its items. The list is then empty.
  template <class Receive>
  void consume(const Receive& receive) {
    PackedList all = std::exchange(*this, PackedList());
    for (Chunk& chunk : all.chunks_) {
      const Chunk own = std::move(chunk);
      decode(own, 0, own.rows.count(), receive);
    }
    for (const Item& item : all.tail_) receive(item);
  }
  /// Returns copies of the items from `begin` to before `end`.
  std::vector<Item> copy(std::size_t begin, std::size_t end) const {
    std::vector<Item> items;
    items.reserve(end - begin);
    read(begin, end, [&](const Item& item) { items.push_back(item); });
    return items;
  }
  /// Returns a copy of one item.
  Item at(std::size_t index) const { return copy(index, index + 1)[0]; }

  /// Calls `change(item)` for the items from `first` on, which may change the item. Removes the items for which it
  /// returns false.
  template <class Change>
  void change(std::size_t first, const Change& change) {
    if (first >= packed_) {
      const auto from = tail_.begin() + static_cast<std::ptrdiff_t>(first - packed_);
      auto kept = from;
      for (auto item = from; item != tail_.end(); ++item) {
        if (!change(*item)) continue;
        if (kept != item) *kept = std::move(*item);
        ++kept;
      }
      tail_.erase(kept, tail_.end());
      return;
    }
    const auto place = static_cast<std::size_t>(chunk_of(first) - chunks_.cbegin());
    PackedList rest;
    rest.chunks_.assign(std::move_iterator(chunks_.begin() + static_cast<std::ptrdiff_t>(place)),
                        std::move_iterator(chunks_.end()));
    chunks_.erase(chunks_.begin() + static_cast<std::ptrdiff_t>(place), chunks_.end());
    rest.tail_ = std::exchange(tail_, {});
    packed_ = rest.chunks_[0].begin;
    std::size_t index = packed_;
    rest.consume([&](const Item& item) {
      add(item);
      if (index++ >= first && !change(back())) tail_.pop_back();
    });
  }
  /// Removes the items from `size` on.
  void truncate(std::size_t size) {
    change(size, [](const Item&) { return false; });
  }

 private:
  struct Chunk {
    std::size_t begin = 0;  // index of its first item
    PackedRows<Codec::kWidth> rows;
    typename Codec::Side side;
  };

  auto chunk_of(std::size_t index) const {
    const auto next = std::ranges::upper_bound(chunks_, index, {}, &Chunk::begin);
    return next == chunks_.begin() || index >= packed_ ? chunks_.cend() : next - 1;
  }

  template <class Receive>
  static void decode(const Chunk& chunk, std::size_t begin, std::size_t end, const Receive& receive) {
    Item item;
    chunk.rows.read(begin, end, [&](const auto& row) {
      Codec::decode(row, chunk.side, item);
      receive(std::as_const(item));
    });
  }

  /// Packs the first `count` items of the tail.
  void pack_first(std::size_t count) {
    std::array<typename PackedRows<Codec::kWidth>::Row, kTogether> rows;
    for (std::size_t begin = 0; begin < count; begin += kTogether) {
      const std::size_t size = std::min(kTogether, count - begin);
      typename Codec::Side side;
      for (std::size_t k = 0; k < size; ++k) Codec::encode(tail_[begin + k], rows[k], side);
      chunks_.push_back({packed_, PackedRows<Codec::kWidth>(std::span(rows).first(size)), std::move(side)});
      packed_ += size;
    }
    tail_.erase(tail_.begin(), tail_.begin() + static_cast<std::ptrdiff_t>(count));
  }

  std::vector<Chunk> chunks_;
  std::size_t packed_ = 0;  // number of items in the chunks
  std::vector<Item> tail_;  // the items after the chunks
};

}  // namespace meristem
