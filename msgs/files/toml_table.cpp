#include "msgs/files/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/base/capacity.hpp"
#include "msgs/files/printable.hpp"
#include "msgs/files/toml_plus_plus.hpp"

namespace quickstrip {

struct TomlTable::Impl {
  std::shared_ptr<const toml::table> document;
  const toml::table* table = nullptr;
  std::string file;
  std::string prefix;  // "loading.", "station[3]."

  [[nodiscard]] std::string field(std::string_view key) const { return fmt::format("{}{}", prefix, key); }
  [[nodiscard]] Impl child(const toml::table* node, std::string child_prefix) const {
    return {document, node, file, std::move(child_prefix)};
  }
};

namespace {

constexpr std::size_t kMaxShownItems = 8;     // of an array: a refusal is one line
constexpr std::size_t kMaxComparedKey = 100;  // a longer key resembles none [bytes]

/// As one would type it, in one line: 9.55 and not 9.5500000000000007.
std::string shown(const toml::node& node) {
  if (node.is_string()) {
    return fmt::format("\"{}\"", printable(node.ref<std::string>()));
  }
  if (node.is_floating_point()) {
    const std::string number = fmt::format("{}", node.ref<double>());
    return number.find_first_not_of("-0123456789") == std::string::npos ? number + ".0" : number;
  }
  if (const toml::array* array = node.as_array(); array != nullptr) {
    if (array->size() > kMaxShownItems) {
      return fmt::format("[{} items]", array->size());
    }
    std::string list;
    for (const toml::node& item : *array) {
      list += (list.empty() ? "" : ", ") + (item.is_array() ? std::string("[...]") : shown(item));
    }
    return fmt::format("[{}]", list);
  }
  if (node.is_table()) {
    return "{...}";
  }
  std::ostringstream stream;
  node.visit([&stream](const auto& value) { stream << value; });
  return printable(stream.str());
}

[[noreturn]] void refuse_node(const std::string& file, const std::string& field, const toml::node& node,
                              std::string_view what) {
  throw FileError{
      fmt::format("{}: {} = {}: {} (line {})", file, field, shown(node), what, node.source().begin.line)};
}

std::string wanted(NumberRange range) {
  return fmt::format("a number from {:g} to {:g}{}{} is wanted", range.from, range.to,
                     range.unit.empty() ? "" : " ", range.unit);
}

double checked_number(const std::string& file, const std::string& field, const toml::node& node,
                      NumberRange range) {
  if (!node.is_number()) {
    refuse_node(file, field, node, wanted(range));
  }
  const double value = node.value<double>().value_or(std::nan(""));
  if (!(std::isfinite(value) && value >= range.from && value <= range.to)) {  // NaN is refused too
    refuse_node(file, field, node, wanted(range));
  }
  return value;
}

std::string quoted_list(std::initializer_list<std::string_view> items) {
  std::string list;
  for (const std::string_view item : items) {
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", item);
  }
  return list;
}

std::string_view nearest(std::string_view key, std::initializer_list<std::string_view> known) {
  std::string_view best;
  std::size_t best_distance = 0;
  for (const std::string_view candidate : known) {
    const std::size_t distance = edit_distance(key, candidate);
    if (best.empty() || distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace

TomlTable::TomlTable(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

TomlTable TomlTable::parse(std::string_view text, std::string_view file) {
  try {
    auto document = std::make_shared<const toml::table>(toml::parse(text));
    const toml::table* root = document.get();
    return TomlTable(std::make_shared<const Impl>(Impl{std::move(document), root, std::string(file), ""}));
  } catch (const toml::parse_error& error) {
    throw FileError{
        fmt::format("{}: line {}: {}", file, error.source().begin.line, printable(error.description(), 200))};
  }
}

bool TomlTable::has(std::string_view key) const {
  return impl_->table->get(key) != nullptr;
}

void TomlTable::allow_only(std::initializer_list<std::string_view> known) const {
  for (const auto& [key, node] : *impl_->table) {
    const std::string_view name = key.str();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      refuse_node(impl_->file, impl_->field(printable(name)), node,
                  name.size() > kMaxComparedKey
                      ? std::string("unknown key")
                      : fmt::format("unknown key; the nearest known one is {}", nearest(name, known)));
    }
  }
}

double TomlTable::number(std::string_view key, NumberRange range) const {
  const toml::node* node = impl_->table->get(key);
  if (node == nullptr) {
    refuse(key, wanted(range));
  }
  return checked_number(impl_->file, impl_->field(key), *node, range);
}

std::optional<double> TomlTable::optional_number(std::string_view key, NumberRange range) const {
  return has(key) ? std::optional<double>(number(key, range)) : std::nullopt;
}

double TomlTable::number_or(std::string_view key, NumberRange range, double fallback) const {
  return has(key) ? number(key, range) : fallback;
}

void TomlTable::require_schema_1() const {
  const toml::node* node = impl_->table->get("schema");
  if (node == nullptr || !node->is_number() || node->value<double>() != 1.0) {
    refuse("schema", "schema = 1 is wanted, the only one so far");
  }
}

std::string TomlTable::text(std::string_view key) const {
  const toml::node* node = impl_->table->get(key);
  if (node == nullptr || !node->is_string()) {
    refuse(key, "a text in quotes is wanted");
  }
  return node->value<std::string>().value_or("");
}

std::int64_t TomlTable::utime(std::string_view key) const {
  constexpr std::string_view kWanted =
      "a date and time of 1970 to 2100 with its offset, such as 2019-08-30T00:00:00Z, is wanted";
  const toml::value<toml::date_time>* value = impl_->table->get_as<toml::date_time>(key);
  if (value == nullptr) {
    refuse(key, kWanted);
  }
  const toml::date_time& when = value->get();
  const std::chrono::year_month_day day{std::chrono::year{when.date.year},
                                        std::chrono::month{when.date.month}, std::chrono::day{when.date.day}};
  const bool is_in_range = when.date.year >= 1970 && when.date.year < 2100 && day.ok();
  if (!is_in_range || !when.offset.has_value()) {
    refuse(key, kWanted);
  }
  const std::int64_t days = std::chrono::sys_days(day).time_since_epoch().count();
  const std::int64_t minutes =
      days * 1440 + std::int64_t{when.time.hour} * 60 + when.time.minute - when.offset->minutes;
  return (minutes * 60 + when.time.second) * 1'000'000 + when.time.nanosecond / 1000;
}

std::size_t TomlTable::choice(std::string_view key, std::initializer_list<std::string_view> choices) const {
  const toml::node* node = impl_->table->get(key);
  if (node != nullptr && node->is_string()) {
    const std::string value = node->value<std::string>().value_or("");
    const auto* const found = std::find(choices.begin(), choices.end(), value);
    if (found != choices.end()) {
      return static_cast<std::size_t>(found - choices.begin());
    }
  }
  std::string what = fmt::format("one of {} is wanted", quoted_list(choices));
  if (node != nullptr && node->is_string()) {
    const std::string value = node->value<std::string>().value_or("");
    if (value.size() <= kMaxComparedKey) {
      what += fmt::format("; the nearest is \"{}\"", nearest(value, choices));
    }
  }
  refuse(key, what);
}

std::string TomlTable::name(std::string_view key) const {
  std::string value = text(key);
  const bool has_control = printable(value, value.size()) != value;
  if (value.empty() || value.size() > kMaxNameBytes - 1 || has_control) {
    refuse(key, fmt::format("a name of 1 to {} bytes without control characters is wanted (it has {})",
                            kMaxNameBytes - 1, value.size()));
  }
  return value;
}

TomlTable TomlTable::table(std::string_view key) const {
  const toml::node* node = impl_->table->get(key);
  if (node == nullptr || !node->is_table()) {
    refuse(key, fmt::format("a table [{}] is wanted", impl_->field(key)));
  }
  return TomlTable(
      std::make_shared<const Impl>(impl_->child(node->as_table(), fmt::format("{}.", impl_->field(key)))));
}

std::optional<TomlTable> TomlTable::optional_table(std::string_view key) const {
  return has(key) ? std::optional<TomlTable>(table(key)) : std::nullopt;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, std::size_t max) const {
  std::vector<TomlTable> list;
  const toml::node* node = impl_->table->get(key);
  if (node == nullptr) {
    return list;
  }
  if (!node->is_array_of_tables()) {
    refuse(key, fmt::format("tables headed [[{}]] are wanted", impl_->field(key)));
  }
  const toml::array& items = *node->as_array();
  if (items.size() > max) {
    refuse_list(key, fmt::format("{} given: at most {} tables [[{}]] fit", items.size(), max, key));
  }
  for (const toml::node& item : items) {
    list.push_back(TomlTable(std::make_shared<const Impl>(
        impl_->child(item.as_table(), fmt::format("{}[{}].", impl_->field(key), list.size() + 1)))));
  }
  return list;
}

std::vector<std::array<double, 2>> TomlTable::pairs(std::string_view key, std::size_t max, NumberRange first,
                                                    NumberRange second) const {
  const toml::node* node = impl_->table->get(key);
  if (node == nullptr || !node->is_array() || node->as_array()->empty()) {
    refuse(key, "a list of pairs [[a, b], [c, d], ...] is wanted");
  }
  const toml::array& items = *node->as_array();
  if (items.size() > max) {
    refuse_list(key, fmt::format("{} pairs given: at most {} fit", items.size(), max));
  }
  std::vector<std::array<double, 2>> list;
  for (const toml::node& item : items) {
    const std::size_t index = list.size();
    const toml::array* pair = item.as_array();
    if (pair == nullptr || pair->size() != 2) {
      refuse_item(key, index, "a pair [a, b] of numbers is wanted");
    }
    const std::string field = fmt::format("{}[{}]", impl_->field(key), index + 1);
    list.push_back({checked_number(impl_->file, field + "[1]", *pair->get(0), first),
                    checked_number(impl_->file, field + "[2]", *pair->get(1), second)});
  }
  return list;
}

void TomlTable::refuse(std::string_view key, std::string_view what) const {
  const toml::node* node = impl_->table->get(key);
  if (node == nullptr) {
    throw FileError{fmt::format("{}: {}: missing: {}", impl_->file, impl_->field(key), what)};
  }
  refuse_node(impl_->file, impl_->field(key), *node, what);
}

void TomlTable::refuse_item(std::string_view key, std::size_t index, std::string_view what) const {
  const toml::array* items = impl_->table->get_as<toml::array>(key);
  if (items == nullptr || items->get(index) == nullptr) {
    refuse(key, what);
  }
  refuse_node(impl_->file, fmt::format("{}[{}]", impl_->field(key), index + 1), *items->get(index), what);
}

void TomlTable::refuse_list(std::string_view key, std::string_view what) const {
  throw FileError{fmt::format("{}: {}: {}", impl_->file, impl_->field(key), what)};
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace quickstrip
