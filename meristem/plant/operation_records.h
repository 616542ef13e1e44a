// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace meristem {

struct OperationRecord;

/// A list of operation records. Skeletons hold it without the definition of a record: sources that read or add records
/// include operation_record.h.
class OperationRecords {
 public:
  OperationRecords() noexcept;                                      ///< makes an empty list, without allocation
  explicit OperationRecords(std::vector<OperationRecord> records);  ///< takes the records of a vector
  OperationRecords(const OperationRecords& other);                  ///< copies the records
  OperationRecords(OperationRecords&& other) noexcept;              ///< moves the records and leaves `other` empty
  OperationRecords& operator=(const OperationRecords& other);       ///< copies the records
  OperationRecords& operator=(OperationRecords&& other) noexcept;   ///< moves the records and leaves `other` empty
  ~OperationRecords();

  std::size_t size() const;                                    ///< number of records
  bool empty() const { return size() == 0; }                   ///< true if there are no records
  std::uint64_t bytes() const;                                 ///< memory of the records, without their texts
  OperationRecord* begin();                                    ///< the first record
  OperationRecord* end();                                      ///< the end of the records
  const OperationRecord* begin() const;                        ///< the first record
  const OperationRecord* end() const;                          ///< the end of the records
  OperationRecord& operator[](std::size_t index);              ///< a record; `index` must be below size()
  const OperationRecord& operator[](std::size_t index) const;  ///< a record; `index` must be below size()

  void add(OperationRecord record);           ///< appends a record
  void append(const OperationRecords& more);  ///< appends copies of all records of another list

  /// Returns true if both lists have equal records in equal order.
  bool operator==(const OperationRecords& other) const;

 private:
  std::unique_ptr<std::vector<OperationRecord>> records_;  // null if no record was ever added
};

}  // namespace meristem
