#include "firmware/nmea/sentence.hpp"

#include <algorithm>

namespace quickstrip::nmea {
namespace {

constexpr std::size_t kMaxTags = 4;
constexpr std::size_t kTalkerLetters = 2;
constexpr std::size_t kFormatterLetters = 3;
constexpr std::size_t kMaxAddress = 12;  // of a maker's own

bool is_printable(char c) {
  return c >= ' ' && c <= '~';
}

bool is_address_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

int hexadecimal(char c) {
  if (c >= '0' && c <= '9') {
    return c - '0';
  }
  if (c >= 'A' && c <= 'F') {
    return c - 'A' + 10;
  }
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/// `digits` are exactly the two that belong to `characters`.
bool proves(std::string_view digits, std::string_view characters) {
  if (digits.size() != 2 || hexadecimal(digits[0]) < 0 || hexadecimal(digits[1]) < 0) {
    return false;
  }
  return static_cast<unsigned>(hexadecimal(digits[0]) * 16 + hexadecimal(digits[1])) == checksum(characters);
}

/// Takes the TAG blocks off the front.
bool pass_over_tags(std::string_view& line) {
  for (std::size_t i = 0; i < kMaxTags && line.starts_with('\\'); ++i) {
    const std::size_t close = line.find('\\', 1);
    if (close == std::string_view::npos) {
      return false;
    }
    const std::string_view tag = line.substr(1, close - 1);
    const std::size_t star = tag.rfind('*');
    if (star == std::string_view::npos || !proves(tag.substr(star + 1), tag.substr(0, star))) {
      return false;
    }
    line.remove_prefix(close + 1);
  }
  return true;
}

Fate cut_address(std::string_view address, Cut& out) {
  if (!std::all_of(address.begin(), address.end(), is_address_letter)) {
    return Fate::kBadAddress;
  }
  if (address.starts_with('P') && address.size() > 1 && address.size() <= kMaxAddress) {
    out.talker = address.substr(0, 1);
    out.formatter = address.substr(1);
    return Fate::kTaken;
  }
  if (address.size() != kTalkerLetters + kFormatterLetters) {
    return Fate::kBadAddress;
  }
  out.talker = address.substr(0, kTalkerLetters);
  out.formatter = address.substr(kTalkerLetters);
  return Fate::kTaken;
}

Fate cut_fields(std::string_view list, Cut& out) {
  while (true) {  // each turn takes a field off the list
    const std::size_t comma = list.find(',');
    if (!out.fields.push_back(list.substr(0, comma))) {
      return Fate::kTooManyFields;
    }
    if (comma == std::string_view::npos) {
      return Fate::kTaken;
    }
    list.remove_prefix(comma + 1);
  }
}

}  // namespace

unsigned checksum(std::string_view characters) {
  unsigned sum = 0;
  for (const char c : characters) {
    sum ^= static_cast<unsigned char>(c);
  }
  return sum;
}

std::string_view without_datagram_header(std::string_view datagram) {
  constexpr std::string_view kHeader("UdPbC\0", 6);
  if (datagram.starts_with(kHeader)) {
    datagram.remove_prefix(kHeader.size());
  }
  return datagram;
}

Fate cut_sentence(std::string_view line, bool allow_missing_checksum, Cut& out) {
  out.fields.clear();
  if (line.empty()) {
    return Fate::kEmpty;
  }
  if (line.size() > kMaxLine) {
    return Fate::kTooLong;
  }
  if (!std::all_of(line.begin(), line.end(), is_printable)) {
    return Fate::kBadCharacter;
  }
  if (!pass_over_tags(line)) {
    return Fate::kBadTag;
  }
  if (line.starts_with('!')) {
    return Fate::kNotUsed;
  }
  if (!line.starts_with('$')) {
    return Fate::kNoSentence;
  }
  line.remove_prefix(1);
  const std::size_t star = line.find('*');
  if (star == std::string_view::npos && !allow_missing_checksum) {
    return Fate::kNoChecksum;
  }
  const std::string_view body = line.substr(0, star);
  if (star != std::string_view::npos && !proves(line.substr(star + 1), body)) {
    return Fate::kBadChecksum;
  }
  const std::size_t comma = body.find(',');
  const Fate address = cut_address(body.substr(0, comma), out);
  if (address != Fate::kTaken || comma == std::string_view::npos) {
    return address;
  }
  return cut_fields(body.substr(comma + 1), out);
}

}  // namespace quickstrip::nmea
