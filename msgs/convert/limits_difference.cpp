#include "msgs/convert/limits_difference.hpp"

#include <cstddef>

namespace quickstrip {
namespace {

std::size_t count_of(const limits_t& limits) {
  return static_cast<std::size_t>(limits.num_criteria);
}

/// count_of(limits) when there is none.
std::size_t find(const limits_t& limits, std::string_view name) {
  std::size_t i = 0;
  while (i < count_of(limits) && get_text(limits.name[i]) != name) {
    ++i;
  }
  return i;
}

const char* unit_of(std::int8_t unit) {
  switch (unit) {
    case limits_t::UNIT_M:
      return " m";
    case limits_t::UNIT_DEG:
      return "\u00b0";
    case limits_t::UNIT_M_S2:
      return " m/s2";
    case limits_t::UNIT_PER_HOUR:
      return "/h";
    case limits_t::UNIT_PER_MINUTE:
      return "/min";
    default:
      return "";
  }
}

bool is_same(const limits_t& a, std::size_t i, const limits_t& b, std::size_t j) {
  return a.quantity[i] == b.quantity[j] && a.place[i] == b.place[j] && a.statistic[i] == b.statistic[j] &&
         a.unit[i] == b.unit[j] && a.limit[i] == b.limit[j] &&
         a.caution_fraction[i] == b.caution_fraction[j] && a.watched[i] == b.watched[j];
}

void add_changed(const limits_t& a, std::size_t i, const limits_t& b, std::size_t j, Sentence& out) {
  out.add("{} ", get_text(b.name[j]));
  if (a.quantity[i] == b.quantity[j] && a.limit[i] != b.limit[j] && a.unit[i] == b.unit[j]) {
    out.add("{:.4g} -> {:.4g}{}", a.limit[i], b.limit[j], unit_of(b.unit[j]));
  } else if (a.statistic[i] == b.statistic[j] && a.caution_fraction[i] != b.caution_fraction[j]) {
    out.add("caution from {:.4g} -> {:.4g} of the limit", a.caution_fraction[i], b.caution_fraction[j]);
  } else {
    out.add("judged otherwise");
  }
}

/// "; " between parts, ": " before the first.
class Parts {
 public:
  void begin(Sentence& out) {
    out.add("{}", is_first_ ? ": " : "; ");
    is_first_ = false;
  }
  [[nodiscard]] bool is_empty() const { return is_first_; }

 private:
  bool is_first_ = true;
};

/// Names that only `in` has.
void add_only(const char* word, const limits_t& in, const limits_t& other, Parts& parts, Sentence& out) {
  for (std::size_t i = 0; i < count_of(in); ++i) {
    if (find(other, get_text(in.name[i])) == count_of(other)) {
      parts.begin(out);
      out.add("{} {}", word, get_text(in.name[i]));
    }
  }
}

}  // namespace

void add_limits_difference(const limits_t& before, const limits_t& now, Sentence& out) {
  const std::string_view old_name = get_text(before.profile_name);
  const std::string_view new_name = get_text(now.profile_name);
  if (old_name == new_name) {
    out.add("\"{}\"", new_name);
  } else {
    out.add("\"{}\" -> \"{}\"", old_name, new_name);
  }
  Parts parts;
  for (std::size_t j = 0; j < count_of(now); ++j) {
    const std::size_t i = find(before, get_text(now.name[j]));
    if (i < count_of(before) && !is_same(before, i, now, j)) {
      parts.begin(out);
      add_changed(before, i, now, j, out);
    }
  }
  add_only("without", before, now, parts, out);
  add_only("new:", now, before, parts, out);
  if (parts.is_empty() && old_name == new_name) {
    out.add(": the same limits in another order, time of exposure or stance");
  }
}

}  // namespace quickstrip
