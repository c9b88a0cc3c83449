#include "msgs/files/text_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>

#include "msgs/files/file_status.hpp"
#include "msgs/files/printable.hpp"

namespace quickstrip {

std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
  const std::string name = printable(path.string(), 1000);
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(path, code);
  if (!std::filesystem::is_regular_file(status)) {
    const bool is_folder = std::filesystem::is_directory(status);
    const bool exists = std::filesystem::exists(status);
    throw FileError{fmt::format("{}: {}", name,
                                is_folder ? "a folder: a file is wanted"
                                : exists  ? "not a file"
                                          : "no such file")};
  }
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (code || size > max_bytes) {
    throw FileError{
        fmt::format("{}: {} bytes: a file of at most {} is wanted, more than its largest can need", name,
                    size, max_bytes)};
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream) {
    throw FileError{fmt::format("{}: cannot be read", name)};
  }
  return text;
}

FileStatus write_text_file(std::string_view text, const std::filesystem::path& path) {
  const std::filesystem::path beside = path.string() + ".part";
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed)) {
    return FileError{
        fmt::format("{}: a folder: the name of a file is wanted", printable(path.string(), 1000))};
  }
  std::ofstream file(beside, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  failed.clear();
  if (file) {
    std::filesystem::rename(beside, path, failed);
  }
  if (!file || failed) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    return FileError{fmt::format("{}: cannot be written", printable(path.string(), 1000))};
  }
  return {};
}

}  // namespace quickstrip
