// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/operation_records.h"

#include <algorithm>
#include <utility>

#include "meristem/plant/operation_record.h"

namespace meristem {

OperationRecords::OperationRecords() noexcept = default;

OperationRecords::OperationRecords(std::vector<OperationRecord> records)
    : records_(records.empty() ? nullptr : std::make_unique<std::vector<OperationRecord>>(std::move(records))) {}

OperationRecords::OperationRecords(const OperationRecords& other)
    : records_(other.empty() ? nullptr : std::make_unique<std::vector<OperationRecord>>(*other.records_)) {}

OperationRecords::OperationRecords(OperationRecords&& other) noexcept = default;

OperationRecords& OperationRecords::operator=(const OperationRecords& other) {
  if (this != &other) *this = OperationRecords(other);
  return *this;
}

OperationRecords& OperationRecords::operator=(OperationRecords&& other) noexcept = default;

OperationRecords::~OperationRecords() = default;

std::size_t OperationRecords::size() const { return records_ == nullptr ? 0 : records_->size(); }

std::uint64_t OperationRecords::bytes() const {
  return records_ == nullptr ? 0 : records_->capacity() * sizeof(OperationRecord);
}

OperationRecord* OperationRecords::begin() { return records_ == nullptr ? nullptr : records_->data(); }

OperationRecord* OperationRecords::end() { return records_ == nullptr ? nullptr : records_->data() + size(); }

const OperationRecord* OperationRecords::begin() const { return records_ == nullptr ? nullptr : records_->data(); }

const OperationRecord* OperationRecords::end() const {
  return records_ == nullptr ? nullptr : records_->data() + size();
}

OperationRecord& OperationRecords::operator[](std::size_t index) { return (*records_)[index]; }

const OperationRecord& OperationRecords::operator[](std::size_t index) const { return (*records_)[index]; }

void OperationRecords::add(OperationRecord record) {
  if (records_ == nullptr) records_ = std::make_unique<std::vector<OperationRecord>>();
  records_->push_back(std::move(record));
}

void OperationRecords::append(const OperationRecords& more) {
  const std::size_t count = more.size();  // a list may be appended to itself
  for (std::size_t k = 0; k < count; ++k) add(more[k]);
}

bool OperationRecords::operator==(const OperationRecords& other) const { return std::ranges::equal(*this, other); }

}  // namespace meristem
