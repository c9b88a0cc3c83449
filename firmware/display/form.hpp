// A form out of JSON: each getter says what is wrong with its field, and goes on, so that all faults of a
// form are told at once.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "firmware/display/entry_form.hpp"
#include "msgs/convert/ranges.hpp"

namespace quickstrip {

class Form {
 public:
  /// Refuses what is no object, with the error on the whole.
  Form(std::string_view json, FieldErrors& errors);
  /// A part of another form: `prefix` before the names of its fields.
  Form(const nlohmann::json& object, std::string prefix, FieldErrors& errors);

  [[nodiscard]] bool is_object() const { return object_.is_object(); }
  [[nodiscard]] bool has(const char* name) const;
  [[nodiscard]] const nlohmann::json& at(const char* name) const;

  /// Within the range; `unit` for the words: "m".
  double number(const char* name, Range range, const char* unit);
  /// Nothing when the field is absent or null.
  std::optional<double> optional_number(const char* name, Range range, const char* unit);
  /// In [0, 360): 360 is north and comes out as 0.
  double direction(const char* name);
  std::int32_t integer(const char* name);
  /// One line of valid UTF-8 without control characters, at most `max_bytes`, not empty.
  std::string text(const char* name, std::size_t max_bytes, const char* what);
  /// One of `words`: its number; -1 and an error otherwise.
  int choice(const char* name, std::initializer_list<std::string_view> words);

  void fault(const std::string& name, std::string text);
  [[nodiscard]] bool is_sound() const { return errors_.empty(); }

 private:
  nlohmann::json object_;
  std::string prefix_;
  FieldErrors& errors_;
};

}  // namespace quickstrip
