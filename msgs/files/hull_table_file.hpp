// The compiled hull table as a file: its words (core/strip/hull_table.hpp), little-endian.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "core/hull/hull.hpp"
#include "core/strip/hull_table.hpp"
#include "msgs/files/file_status.hpp"

namespace quickstrip {

/// Reads the whole file into `memory`, which `out` looks at from then on; allocates nothing that stays. One
/// line names the file and why it is refused: not a file, too large, no table, another version, cut short,
/// damaged, compiled for another hull than `hull`.
FileStatus read_hull_table(const std::filesystem::path& path, const Hull& hull,
                           std::span<std::uint32_t> memory, std::optional<HullTable>& out);

/// Which program made the table, of what: the text in its header, fit to print.
std::string provenance_text(const HullTable& table);

/// Written beside, then renamed.
FileStatus write_hull_table(std::span<const std::uint32_t> words, const std::filesystem::path& path);

/// For whoever asks for loads that only a table has.
inline constexpr const char* kHullTableWanted =
    "--loads = boundary-value: --table FILE is wanted too, made by `quickstrip-hull compile`";

}  // namespace quickstrip
