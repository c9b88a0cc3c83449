#include "tests/arch/source_tree.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace quickstrip::arch {
namespace {

namespace fs = std::filesystem;

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool ends_in(const std::string& name, const std::vector<std::string>& endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](const std::string& ending) { return name.ends_with(ending); });
}

// Where the literal or comment that opens at `at` ends (one past), or `at` when none opens there.
std::size_t end_of_blank(std::string_view text, std::size_t at) {
  const auto find = [&](std::string_view what, std::size_t from) {
    const std::size_t found = text.find(what, from);
    return found == std::string_view::npos ? text.size() : found;
  };
  if (text.substr(at, 2) == "//") {
    return find("\n", at);
  }
  if (text.substr(at, 2) == "/*") {
    return std::min(text.size(), find("*/", at + 2) + 2);
  }
  if (text.substr(at, 2) == "R\"") {
    const std::size_t open = find("(", at);
    std::string close(1, ')');
    close.append(text.substr(at + 2, open - at - 2)).append(1, '"');
    return std::min(text.size(), find(close, open) + close.size());
  }
  const char quote = text[at];
  const bool separates_digits = quote == '\'' && at > 0 && is_word(text[at - 1]);
  if (quote != '"' && (quote != '\'' || separates_digits)) {
    return at;
  }
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != quote && text[end] != '\n') {
    end += text[end] == '\\' ? 2U : 1U;
  }
  return std::min(text.size(), end + 1);
}

}  // namespace

std::vector<SourceFile> source_files(const std::vector<std::string>& folders,
                                     const std::vector<std::string>& endings) {
  const fs::path root = QUICKSTRIP_SOURCE_DIR;
  std::vector<SourceFile> found;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.is_regular_file() && ends_in(entry.path().filename().string(), endings)) {
        found.push_back({fs::relative(entry.path(), root).generic_string(), read(entry.path())});
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return found;
}

SourceFile source_file(const std::string& path) {
  return {path, read(fs::path(QUICKSTRIP_SOURCE_DIR) / path)};
}

std::string code_of(std::string_view text) {
  std::string code(text);
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = end_of_blank(text, at);
    for (std::size_t i = at; i < end; ++i) {
      code[i] = code[i] == '\n' ? '\n' : ' ';
    }
    at = std::max(end, at + 1);
  }
  return code;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> includes_of(std::string_view text) {
  std::vector<std::string> found;
  for (const std::string& line : lines_of(text)) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') {
      continue;
    }
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) {
      continue;
    }
    const std::size_t open = line.find_first_of("<\"", word);
    const std::size_t close = open == std::string::npos ? open : line.find_first_of(">\"", open + 1);
    if (close != std::string::npos) {
      found.push_back(line.substr(open, close - open + 1));
    }
  }
  return found;
}

std::vector<std::string> words_of(std::string_view code) {
  std::vector<std::string> words;
  std::size_t at = 0;
  while (at < code.size()) {
    std::size_t end = at;
    while (end < code.size() && (is_word(code[end]) || (end > at && code.substr(end, 2) == "::" &&
                                                        end + 2 < code.size() && is_word(code[end + 2])))) {
      end += is_word(code[end]) ? 1U : 2U;
    }
    if (end > at) {
      words.emplace_back(code.substr(at, end - at));
    }
    at = std::max(end, at + 1);
  }
  return words;
}

std::vector<std::string> citations_of(std::string_view text) {
  std::set<std::string> found;
  std::size_t open = text.find('[');
  for (; open != std::string_view::npos; open = text.find('[', open + 1)) {
    std::size_t end = open + 1;
    while (end < text.size() && (is_word(text[end]) || text[end] == '-' || text[end] == '\'')) {
      ++end;
    }
    if (end == text.size() || text[end] != ']') {
      continue;
    }
    std::string tag(text.substr(open + 1, end - open - 1));
    const std::size_t year = tag.find_first_of("0123456789");
    const std::size_t digits = year == std::string::npos ? 0 : tag.find_first_not_of("0123456789", year);
    const std::size_t num_digits =
        year == std::string::npos ? 0 : (digits == std::string::npos ? tag.size() : digits) - year;
    if (num_digits == 4 && year >= 2 && std::isalpha(static_cast<unsigned char>(tag[0])) != 0) {
      found.insert(std::move(tag));
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace quickstrip::arch
