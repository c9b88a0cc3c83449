// A whole text file into memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace quickstrip {

/// Throws FileError. Refuses a file above max_bytes unread, so that a wrong path does not fill the memory.
std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace quickstrip
