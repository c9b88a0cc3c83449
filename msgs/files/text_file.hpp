// A whole text file into memory, and out of it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "msgs/files/file_status.hpp"

namespace quickstrip {

/// Throws FileError. Refuses a file above max_bytes unread, so that a wrong path does not fill the memory.
std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Written beside, then renamed: a failed run leaves neither a half-written file nor a changed one.
FileStatus write_text_file(std::string_view text, const std::filesystem::path& path);

}  // namespace quickstrip
