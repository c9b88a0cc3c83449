#include "msgs/files/hull_table_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <string>

#include "msgs/files/printable.hpp"
#include "msgs/files/text_file.hpp"

namespace quickstrip {
namespace {

static_assert(std::endian::native == std::endian::little, "words are copied as they lie in the file");

constexpr std::size_t kWordBytes = sizeof(std::uint32_t);

FileError refused(const std::filesystem::path& path, const std::string& reason) {
  return FileError{fmt::format("{}: {}", printable(path.string(), 1000), reason)};
}

}  // namespace

FileStatus read_hull_table(const std::filesystem::path& path, const Hull& hull,
                           std::span<std::uint32_t> memory, std::optional<HullTable>& out) {
  out.reset();
  std::string bytes;
  try {
    bytes = read_text_file(path, memory.size_bytes());
  } catch (const FileError& error) {
    return error;
  }
  std::memcpy(memory.data(), bytes.data(), bytes.size() - bytes.size() % kWordBytes);
  const Result<HullTable> table = HullTable::view(memory.first(bytes.size() / kWordBytes));
  if (!table) {
    return refused(path, message(table.error()));
  }
  if (bytes.size() % kWordBytes != 0) {
    return refused(path, message(Error::kHullTableTruncated));
  }
  if (const Status same = table->check_hull(hull); !same) {
    return refused(
        path, fmt::format("{}; one compiled for \"{}\" is wanted", message(same.error()), hull.name.view()));
  }
  out = *table;
  return {};
}

std::string provenance_text(const HullTable& table) {
  std::string text;
  for (const std::uint32_t word : table.text()) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      const char byte = static_cast<char>((word >> shift) & 0xFFU);
      if (byte == '\0') {
        return printable(text, text.size());
      }
      text += byte;
    }
  }
  return printable(text, text.size());
}

FileStatus write_hull_table(std::span<const std::uint32_t> words, const std::filesystem::path& path) {
  std::string bytes(words.size_bytes(), '\0');
  std::memcpy(bytes.data(), words.data(), words.size_bytes());
  return write_text_file(bytes, path);
}

}  // namespace quickstrip
