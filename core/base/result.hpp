// Result<T>: a value, or the reason why there is none. For faults of input and numerics; our own faults are
// QS_CHECK's. Costs: no heap; sizeof(T) plus one code. Each code is worded once, in result.cpp.
#pragma once

#include <cstdint>

#include "core/base/check.hpp"

namespace quickstrip {

enum class Error : std::uint8_t {
  kNone = 0,
  // input
  kNotFinite,
  kOutOfRange,
  kTooMany,
  kTooFewStations,
  kStationsNotOrdered,
  kContourNotOrdered,
  kNoImmersedVolume,
  kDraughtAboveDeck,
  kDraughtNotSupported,  // a hull of minimal form (breadth, draught, area) has one draught only
  kUnstable,             // GM is not positive
  kEmptySpectrum,
  kSpeedOutOfGrid,
  // state
  kNotConfigured,
  kTableCorrupt,
  // a compiled hull table (strip/hull_table.hpp)
  kHullTableForeign,
  kHullTableVersion,
  kHullTableTruncated,
  kHullTableCorrupt,
  kHullTableOtherHull,
  kHullTableNeeded,
  // numerics
  kSingular,
};

/// One short clause of English, no full stop: "GM is not positive".
const char* message(Error error);

template <typename T>
class [[nodiscard]] Result {
 public:
  Result(const T& value) : value_(value) {}                                 // NOLINT: implicit on purpose
  Result(Error error) : error_(error) { QS_CHECK(error != Error::kNone); }  // NOLINT

  [[nodiscard]] bool ok() const { return error_ == Error::kNone; }
  explicit operator bool() const { return ok(); }
  [[nodiscard]] Error error() const { return error_; }
  const T& value() const {
    QS_CHECK(ok());
    return value_;
  }
  const T& operator*() const { return value(); }
  const T* operator->() const { return &value(); }

 private:
  T value_{};
  Error error_ = Error::kNone;
};

/// A Result without a value.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : error_(error) {}  // NOLINT: implicit on purpose
  [[nodiscard]] bool ok() const { return error_ == Error::kNone; }
  explicit operator bool() const { return ok(); }
  [[nodiscard]] Error error() const { return error_; }

 private:
  Error error_ = Error::kNone;
};

}  // namespace quickstrip
