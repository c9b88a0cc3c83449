// Quickstrip's own sea file (*.sea): hourly buoy spectra, text, without loss. Format: FORMAT.md beside this.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "msgs/files/file_status.hpp"
#include "sim/sea_files/buoy_record.hpp"

namespace quickstrip {

/// Refusals: "FILE:LINE: field = value: what would be right". On refusal `out` is as it was.
FileStatus read_sea_file(const std::filesystem::path& path, BuoyRecord& out);
FileStatus parse_sea_file(std::string_view text, std::string_view file, BuoyRecord& out);

/// The text of a file; numbers in their shortest exact form.
std::string sea_file_text(const BuoyRecord& record);

/// Written beside, then renamed: a failed run leaves no half-written file.
FileStatus write_sea_file(const BuoyRecord& record, const std::filesystem::path& path);

}  // namespace quickstrip
