// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/packed_list.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::packed_list_test {

/// Two words, and a pointer that is no number.
struct Item {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  std::shared_ptr<int> third{};

  bool operator==(const Item&) const = default;
};

struct Codec {
  static constexpr std::size_t kWidth = 2;
  static constexpr std::size_t kOpen = 700;
  struct Side {
    std::vector<std::shared_ptr<int>> third{};
    std::uint64_t bytes() const { return third.capacity() * sizeof(third[0]); }
  };
  static void encode(const Item& item, std::array<std::uint32_t, kWidth>& row, Side& side) {
    row = {item.first, item.second};
    side.third.push_back(item.third);
  }
  static void decode(const std::array<std::uint32_t, kWidth>& row, const Side& side, Item& item) {
    item = {row[0], row[1], side.third.back()};
  }
};
using List = PackedList<Item, Codec>;

Item item(std::size_t k) { return {static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(k / 500), nullptr}; }

std::vector<Item> items(std::size_t count) {
  std::vector<Item> made;
  for (std::size_t k = 0; k < count; ++k) made.push_back(item(k));
  return made;
}

List list(const std::vector<Item>& items) {
  List made;
  for (const Item& one : items) made.add(one);
  return made;
}

std::vector<Item> all_of(const List& list) { return list.copy(0, list.size()); }

TEST(PackedList, HasTheItemsThatWereAddedPackedOrNot) {
  for (const std::size_t count : {0, 1, 255, 256, 257, 700, 701, 1024, 3000}) {
    List made = list(items(count));
    EXPECT_EQ(made.size(), count);
    EXPECT_EQ(all_of(made), items(count));
    made.pack_chunks();
    EXPECT_EQ(all_of(made), items(count));
    made.pack();
    EXPECT_EQ(made.size(), count);
    EXPECT_EQ(made.empty(), count == 0);
    EXPECT_EQ(all_of(made), items(count));
  }
}

TEST(PackedList, ReadsAnyRange) {
  List made = list(items(2000));
  for (std::uint64_t k = 0; k < 200; ++k) {
    const auto begin = static_cast<std::size_t>(RandomKey(1).uniform(k, 0, 2001));
    const auto end = static_cast<std::size_t>(RandomKey(2).uniform(k, static_cast<double>(begin), 2001));
    std::size_t next = begin;
    made.read(begin, end, [&](const Item& one) { EXPECT_EQ(one, item(next++)); });
    EXPECT_EQ(next, end);
    if (k == 100) made.pack();
  }
  EXPECT_EQ(made.at(1999), item(1999));
}

TEST(PackedList, WordsThatAreEqualInAChunkTakeNoMemory) {
  List equal, different;
  for (std::uint32_t k = 0; k < 256'000; ++k) {
    equal.add({7, 8, nullptr});
    different.add({k, 8, nullptr});
  }
  equal.pack();
  different.pack();
  EXPECT_NEAR(static_cast<double>(different.bytes()) - static_cast<double>(equal.bytes()), 4 * 256'000, 1);
}

TEST(PackedList, KeepsWhatIsNoNumber) {
  const auto pointer = std::make_shared<int>(3);
  List made;
  for (int k = 0; k < 256; ++k) made.add({1, 1, pointer});
  made.pack();
  EXPECT_EQ(made.at(77).third, pointer);
  EXPECT_EQ(pointer.use_count(), 257);
  made = List();
  EXPECT_EQ(pointer.use_count(), 1);
}

TEST(PackedList, ChangesAndRemovesItemsFromAnyPlaceOn) {
  for (const bool is_packed : {false, true}) {
    for (const std::size_t first : {0, 100, 256, 700, 1400, 1999, 2000}) {
      List made = list(items(2000));
      if (is_packed) made.pack();
      made.change(first, [](Item& one) {
        one.second = 1000;
        return one.first % 3 != 0;
      });
      std::vector<Item> expected;
      for (Item one : items(2000)) {
        const bool changes = one.first >= first;
        if (changes) one.second = 1000;
        if (!changes || one.first % 3 != 0) expected.push_back(one);
      }
      EXPECT_EQ(all_of(made), expected) << first;
      made.truncate(first);
      EXPECT_EQ(made.size(), first);
      EXPECT_EQ(all_of(made), items(first));
      made.add(item(first));
      EXPECT_EQ(made.back(), item(first));
    }
  }
}

TEST(PackedList, ListsOfAnyLengthsAreJoined) {
  List joined;
  std::size_t count = 0;
  for (const std::size_t length : {1, 0, 300, 256, 5, 5, 255, 1000, 128, 129, 3, 2000}) {
    List part;
    for (std::size_t k = 0; k < length; ++k) part.add(item(count++));
    if (length % 2 == 0) part.pack();
    joined.append(std::move(part));
  }
  EXPECT_EQ(all_of(joined), items(count));
  joined.pack();
  EXPECT_EQ(all_of(joined), items(count));
}

TEST(PackedList, ManyShortListsMakeNoShortChunks) {
  List joined, whole = list(items(5000));
  for (std::size_t k = 0; k < 5000; ++k) {
    List one = list({item(k)});
    one.pack();
    joined.append(std::move(one));
  }
  joined.pack();
  whole.pack();
  EXPECT_LT(joined.bytes(), whole.bytes() * 11 / 10);
}

TEST(PackedList, IsEmptyAfterItIsConsumed) {
  List made = list(items(1000));
  std::vector<Item> received;
  made.consume([&](const Item& one) { received.push_back(one); });
  EXPECT_EQ(received, items(1000));
  EXPECT_TRUE(made.empty());
}

}  // namespace meristem::packed_list_test
