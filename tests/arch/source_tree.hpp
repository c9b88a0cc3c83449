// The project's own text files as the architecture tests read them: path, text, and code without comments
// and strings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quickstrip::arch {

struct SourceFile {
  std::string path;  // from the repository root, with forward slashes
  std::string text;
};

/// Every file below `folders` (from the repository root) whose name ends in one of `endings`, sorted.
std::vector<SourceFile> source_files(const std::vector<std::string>& folders,
                                     const std::vector<std::string>& endings);

/// One file by its path from the repository root; its text is empty when it is not there.
SourceFile source_file(const std::string& path);

/// The same text with comments, strings and character literals blanked; lines stay where they were.
std::string code_of(std::string_view text);

std::vector<std::string> lines_of(std::string_view text);

/// What `#include` names on each line, with its quotes or angle brackets.
std::vector<std::string> includes_of(std::string_view text);

/// Identifiers of the code; a name behind `::` keeps what stands before it ("std::vector").
std::vector<std::string> words_of(std::string_view code);

/// [Author1900] citations of a text, each once, without the brackets.
std::vector<std::string> citations_of(std::string_view text);

}  // namespace quickstrip::arch
