// FileStatus: how reading or writing a file ended. Nothing to say, or one line for the user:
// "FILE: field = value: what would be right".
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace quickstrip {

struct FileError {
  std::string line;
};

class [[nodiscard]] FileStatus {
 public:
  FileStatus() = default;
  FileStatus(FileError error) : error_(std::move(error)) {}  // NOLINT: implicit on purpose

  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  /// Empty when ok.
  [[nodiscard]] std::string line() const { return error_ ? error_->line : std::string(); }

 private:
  std::optional<FileError> error_;
};

}  // namespace quickstrip
