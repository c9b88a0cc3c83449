#include "tests/fuzz/mutations.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace quickstrip::fuzz {
namespace {

constexpr std::array<std::string_view, 20> kWords{
    "nan", "inf",     "-1",       "0",       "1e308", "-1e308", "1e-308",       "9223372036854775807",
    "[[",  "]]",      "\"",       "= {}",    "true",  "\r\n",   "\xEF\xBB\xBF", "1970-01-01T00:00:00Z",
    "#",   "[[[[[[[", "\xC0\x80", "00000000"};

std::size_t below(std::size_t end, std::mt19937& random) {
  return end == 0 ? 0 : random() % end;
}

Bytes::iterator at(Bytes& bytes, std::size_t i) {
  return bytes.begin() + static_cast<std::ptrdiff_t>(i);
}

/// A stretch of `from` in place of as many bytes, or between them.
void put(std::span<const std::uint8_t> stretch, bool replaces, Bytes& bytes, std::mt19937& random) {
  const std::size_t place = below(bytes.size() + 1, random);
  if (replaces) {
    bytes.erase(at(bytes, place), at(bytes, std::min(bytes.size(), place + stretch.size())));
  }
  bytes.insert(at(bytes, place), stretch.begin(), stretch.end());
}

std::span<const std::uint8_t> stretch_of(const Bytes& bytes, std::mt19937& random) {
  const std::size_t begin = below(bytes.size(), random);
  const std::size_t size = below(std::min<std::size_t>(bytes.size() - begin, 200) + 1, random);
  return std::span(bytes).subspan(begin, size);
}

void change(const std::vector<Bytes>& seeds, Bytes& bytes, std::mt19937& random) {
  switch (random() % 7) {
    case 0:
      if (!bytes.empty()) {
        bytes[below(bytes.size(), random)] ^= static_cast<std::uint8_t>(1u << (random() % 8));
      }
      break;
    case 1: {
      const Bytes any{static_cast<std::uint8_t>(random() & 0xFFu)};
      put(any, true, bytes, random);
      break;
    }
    case 2: {
      const std::string_view word = kWords[below(kWords.size(), random)];
      const Bytes text(word.begin(), word.end());
      put(text, random() % 2 == 0, bytes, random);
      break;
    }
    case 3: {
      Bytes number(std::size_t{1} << (random() % 4),
                   random() % 2 == 0 ? std::uint8_t{0xFF} : std::uint8_t{0});
      number[0] = static_cast<std::uint8_t>(random() & 0xFFu);
      put(number, true, bytes, random);
      break;
    }
    case 4: {
      const std::size_t begin = below(bytes.size(), random);
      bytes.erase(at(bytes, begin), at(bytes, std::min(bytes.size(), begin + 1 + below(100, random))));
      break;
    }
    case 5: {
      const Bytes copy = bytes;
      put(stretch_of(copy, random), false, bytes, random);
      break;
    }
    default:
      put(stretch_of(seeds[below(seeds.size(), random)], random), random() % 2 == 0, bytes, random);
      break;
  }
}

}  // namespace

Bytes mutated(const std::vector<Bytes>& seeds, std::mt19937& random) {
  Bytes bytes = seeds[below(seeds.size(), random)];
  if (bytes.empty()) {  // messages: over a good one
    bytes.assign(below(120, random), 0);
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random() & 0xFFu); });
  }
  const std::size_t num_changes = 1 + below(8, random);
  for (std::size_t i = 0; i < num_changes; ++i) {
    change(seeds, bytes, random);
  }
  return bytes;
}

}  // namespace quickstrip::fuzz
