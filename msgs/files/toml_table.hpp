// A TOML table as our readers want it: every number finite and in a stated range, unknown keys refused with
// the nearest known one named, each refusal one line that names file, field, value and what would be right.
// The only place that sees toml++. Inside msgs/files a refusal is thrown as FileError; the readers catch it
// at their door, so that no caller sees an exception.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "msgs/files/file_status.hpp"

namespace quickstrip {

/// Both ends included.
struct NumberRange {
  double from = 0.0;
  double to = 0.0;
  std::string_view unit;  // "m", "" for a pure number
};

class TomlTable {
 public:
  /// `file` is the name that refusals quote. Throws FileError on bad syntax, with the line.
  static TomlTable parse(std::string_view text, std::string_view file);

  [[nodiscard]] bool has(std::string_view key) const;
  /// Throws FileError for the first key that is not among `known`, naming the nearest known one.
  void allow_only(std::initializer_list<std::string_view> known) const;

  [[nodiscard]] double number(std::string_view key, NumberRange range) const;
  [[nodiscard]] std::optional<double> optional_number(std::string_view key, NumberRange range) const;
  [[nodiscard]] double number_or(std::string_view key, NumberRange range, double fallback) const;
  /// Throws FileError unless `schema = 1`, the only one so far.
  void require_schema_1() const;
  [[nodiscard]] std::string text(std::string_view key) const;
  /// A date and time with its offset (2019-08-30T00:00:00Z), 1970 ... 2100; microseconds since the epoch.
  [[nodiscard]] std::int64_t utime(std::string_view key) const;
  /// One of `choices`, the nearest named in the refusal; returns its index.
  [[nodiscard]] std::size_t choice(std::string_view key,
                                   std::initializer_list<std::string_view> choices) const;
  /// Not empty, at most kMaxNameBytes - 1 bytes, no control characters.
  [[nodiscard]] std::string name(std::string_view key) const;
  [[nodiscard]] TomlTable table(std::string_view key) const;
  [[nodiscard]] std::optional<TomlTable> optional_table(std::string_view key) const;
  /// An array of tables, [[key]]; empty when absent.
  [[nodiscard]] std::vector<TomlTable> tables(std::string_view key, std::size_t max) const;
  /// An array of [a, b], each of the pair in its range.
  [[nodiscard]] std::vector<std::array<double, 2>> pairs(std::string_view key, std::size_t max,
                                                         NumberRange first, NumberRange second) const;

  /// "FILE: field = value: what (line N)"; a key that is absent reads "FILE: field: missing; what".
  [[noreturn]] void refuse(std::string_view key, std::string_view what) const;
  /// The same for item `index` (from 0) of an array; fields count from 1.
  [[noreturn]] void refuse_item(std::string_view key, std::size_t index, std::string_view what) const;
  /// "FILE: field: what", of a list as a whole.
  [[noreturn]] void refuse_list(std::string_view key, std::string_view what) const;

 private:
  struct Impl;  // keeps toml++ out of this header
  explicit TomlTable(std::shared_ptr<const Impl> impl);
  std::shared_ptr<const Impl> impl_;
};

/// Number of single-character insertions, deletions and replacements that turn a into b.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace quickstrip
