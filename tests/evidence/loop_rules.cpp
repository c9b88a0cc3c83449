#include "tests/evidence/loop_rules.hpp"

#include <algorithm>
#include <regex>

#include "tests/arch/source_tree.hpp"

namespace quickstrip::evidence {
namespace {

/// From an opening bracket to behind its closing one.
std::size_t behind_bracket(const std::string& code, std::size_t open, char opening, char closing) {
  int depth = 0;
  for (std::size_t i = open; i < code.size(); ++i) {
    depth += code[i] == opening ? 1 : code[i] == closing ? -1 : 0;
    if (depth == 0) {
      return i + 1;
    }
  }
  return code.size();
}

/// The statement or block that begins at `from`.
std::string body_at(const std::string& code, std::size_t from) {
  const std::size_t begin = code.find_first_not_of(" \n\t", from);
  if (begin == std::string::npos) {
    return {};
  }
  const std::size_t end =
      code[begin] == '{' ? behind_bracket(code, begin, '{', '}') : code.find(';', begin) + 1;
  return code.substr(begin, end - begin);
}

bool is_assigned(const std::string& body, const std::string& name) {
  const std::regex assignment("(\\+\\+|--)\\s*" + name + "\\b|\\b" + name +
                              R"(\s*(\+\+|--|[+\-*/%&|^]=|<<=|>>=|=(?!=)))");
  return std::regex_search(body, assignment);
}

/// `header`: between the brackets.
bool is_plainly_counted(const std::string& header, const std::string& body) {
  const std::size_t first = header.find(';');
  if (first == std::string::npos) {
    return header.find(':') != std::string::npos;  // over a range
  }
  const std::size_t second = header.find(';', first + 1);
  const std::string start = header.substr(0, first);
  const std::string condition = header.substr(first + 1, second - first - 1);
  const std::string step = header.substr(second + 1);
  std::smatch found;
  static const std::regex kStart(
      R"((?:auto|int|std::size_t|std::ptrdiff_t|std::uint\d+_t|unsigned|long|int\d+_t)\s+(\w+)\s*(=|\{))");
  if (!std::regex_search(start, found, kStart)) {
    return false;
  }
  const std::string name = found[1];
  const std::regex compares("(^|&&|\\s)" + name + R"((\s*\+\s*\w+)?\s*(<|>|<=|>=|!=)\s*[^=])");
  const std::regex counts_down(name + R"(\s*--\s*>\s*0)");
  const std::regex steps(R"(^\s*(\+\+|--)\s*)" + name + R"(\s*$|^\s*)" + name + R"(\s*[+\-]=)");
  const bool is_stepped = std::regex_search(condition, counts_down) ||
                          (std::regex_search(condition, compares) && std::regex_search(step, steps));
  return is_stepped && !is_assigned(body, name) && condition.find("||") == std::string::npos;
}

/// `while (i + 1 < n && ...) { ++i; }`, or down to a bound: one step and nothing else in the body.
bool is_plain_search(const std::string& header, const std::string& body) {
  static const std::regex kStep(R"(^\{?\s*(\+\+|--)([\w.]+);\s*\}?$)");
  std::smatch found;
  if (!std::regex_search(body, found, kStep) || header.find("||") != std::string::npos) {
    return false;
  }
  const std::string name = std::regex_replace(found[2].str(), std::regex("\\."), "\\.");
  const std::string against = found[1] == "++" ? "<" : ">";
  return std::regex_search(header, std::regex("^\\s*" + name + R"((\s*\+\s*\d+)?\s*)" + against + "\\s"));
}

struct Loop {
  std::size_t at = 0;
  bool is_counted = false;
};

/// The do that `while (false)` ends.
void mark_last_do(std::vector<Loop>& loops, const std::string& code) {
  for (std::size_t i = loops.size(); i-- > 0;) {
    if (code.compare(loops[i].at, 2, "do") == 0 && !loops[i].is_counted) {
      loops[i].is_counted = true;
      return;
    }
  }
}

std::vector<Loop> loops_of(const std::string& code) {
  std::vector<Loop> loops;
  static const std::regex kLoop(R"(\b(for|while|do)\b)");
  for (std::sregex_iterator i(code.begin(), code.end(), kLoop), end; i != end; ++i) {
    const auto at = static_cast<std::size_t>(i->position());
    const std::size_t open = code.find_first_not_of(" \n\t", at + static_cast<std::size_t>(i->length()));
    if ((*i)[1] == "do" || open == std::string::npos || code[open] != '(') {
      loops.push_back({at, false});
      continue;
    }
    const std::size_t behind = behind_bracket(code, open, '(', ')');
    const std::string header = code.substr(open + 1, behind - open - 2);
    const std::string body = body_at(code, behind);
    const bool is_once = header == "false";  // the end of a do that runs once
    const bool is_for = (*i)[1] == "for";
    loops.push_back(
        {at, is_for ? is_plainly_counted(header, body) : is_once || is_plain_search(header, body)});
    if (is_once && !loops.empty()) {
      mark_last_do(loops, code);
    }
  }
  return loops;
}

bool has_reason(const std::vector<std::string>& lines, std::size_t line) {
  const auto says = [&](std::size_t number) {
    return number >= 1 && number <= lines.size() &&
           lines[number - 1].find("// bounded: ") != std::string::npos;
  };
  return says(line) || says(line - 1);
}

}  // namespace

std::vector<LoopWithoutReason> loops_without_reason(std::string_view source) {
  const std::string code = arch::code_of(source);
  const std::vector<std::string> lines = arch::lines_of(source);
  std::vector<LoopWithoutReason> found;
  for (const Loop& loop : loops_of(code)) {
    const auto line = static_cast<std::size_t>(
        1 + std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(loop.at), '\n'));
    if (!loop.is_counted && !has_reason(lines, line)) {
      found.push_back({line, lines[line - 1]});
    }
  }
  return found;
}

std::size_t num_loops(std::string_view source) {
  return loops_of(arch::code_of(source)).size();
}

}  // namespace quickstrip::evidence
