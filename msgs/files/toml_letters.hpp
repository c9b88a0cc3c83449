// A look at TOML text before toml++ sees it: outside quotes and comments TOML is ASCII. toml++ 3.3 takes a
// letter of U+00A1 to U+0499 there for "unreachable" when it looks for blanks, which is undefined behaviour.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace quickstrip {

struct LetterOutsideQuotes {
  std::size_t line = 0;  // from 1
  std::string letter;    // one character, printable
};

/// The first byte above ASCII outside quotes and comments; a byte-order mark at the front is none.
std::optional<LetterOutsideQuotes> letter_outside_quotes(std::string_view text);

}  // namespace quickstrip
