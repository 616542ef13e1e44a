// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/operation_records.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/plant/operation_record.h"

namespace meristem::operation_records_test {

OperationRecords cuts(int count) {
  OperationRecords records;
  for (int k = 0; k < count; ++k) records.add({.act = "cut", .iteration = k});
  return records;
}

std::vector<int> iterations(const OperationRecords& records) {
  std::vector<int> result;
  for (const OperationRecord& record : records) result.push_back(record.iteration);
  return result;
}

TEST(OperationRecords, AnEmptyListHasNoRecordsAndTakesNoMemory) {
  const OperationRecords none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.bytes(), 0U);
  EXPECT_EQ(iterations(none), std::vector<int>());
  EXPECT_EQ(none, OperationRecords(std::vector<OperationRecord>()));
  EXPECT_EQ(OperationRecords(none), none);
}

TEST(OperationRecords, CopiesAreIndependent) {
  OperationRecords first = cuts(3);
  const OperationRecords copy = first;
  first[1].iteration = 7;
  EXPECT_EQ(iterations(first), (std::vector{0, 7, 2}));
  EXPECT_EQ(iterations(copy), (std::vector{0, 1, 2}));
  EXPECT_NE(first, copy);
  first = copy;
  EXPECT_EQ(first, copy);
  EXPECT_GE(copy.bytes(), 3 * sizeof(OperationRecord));
}

TEST(OperationRecords, MovedListsAreEmpty) {
  OperationRecords first = cuts(2);
  const OperationRecords moved = std::move(first);
  EXPECT_EQ(moved.size(), 2U);
  EXPECT_TRUE(first.empty());  // NOLINT(bugprone-use-after-move): the state is part of the interface
  first.add({.iteration = 5});
  EXPECT_EQ(iterations(first), std::vector{5});
}

TEST(OperationRecords, AppendKeepsTheOrderAlsoOfAListToItself) {
  OperationRecords all = cuts(1);
  all.append(cuts(2));
  all.append({});
  EXPECT_EQ(iterations(all), (std::vector{0, 0, 1}));
  all.append(all);
  EXPECT_EQ(iterations(all), (std::vector{0, 0, 1, 0, 0, 1}));
}

}  // namespace meristem::operation_records_test
