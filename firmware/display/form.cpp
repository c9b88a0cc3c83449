#include "firmware/display/form.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace quickstrip {
namespace {

constexpr int kMaxDepth = 8;  // of nesting: no form of ours has more than three

bool is_too_deep(std::string_view json) {
  int depth = 0;
  bool is_in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (is_in_text) {
      i += c == '\\' ? 1U : 0U;
      is_in_text = c != '"';
    } else if (c == '"') {
      is_in_text = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxDepth) {
        return true;
      }
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

/// nlohmann's parser has judged the UTF-8; control characters it lets through as escapes.
bool is_one_line(const std::string& text) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      return false;
    }
  }
  return text.find_first_not_of(' ') != std::string::npos;
}

std::string range_words(Range range, const char* unit) {
  return fmt::format("between {:g} and {:g}{}{}", range.from, range.to, *unit == '\0' ? "" : " ", unit);
}

}  // namespace

Form::Form(std::string_view json, FieldErrors& errors) : errors_(errors) {
  if (!is_too_deep(json)) {
    object_ = nlohmann::json::parse(json, nullptr, false);
  }
  if (!object_.is_object()) {
    object_ = nullptr;
    fault("", "not a form that this display knows");
  }
}

Form::Form(const nlohmann::json& object, std::string prefix, FieldErrors& errors)
    : object_(object), prefix_(std::move(prefix)), errors_(errors) {
  if (!object_.is_object()) {
    object_ = nullptr;
    fault("", "not a form that this display knows");
  }
}

void Form::fault(const std::string& name, std::string text) {
  const std::string joint = prefix_.empty() || name.empty() ? "" : ".";
  errors_.push_back({prefix_ + joint + name, std::move(text)});
}

bool Form::has(const char* name) const {
  return object_.is_object() && object_.contains(name) && !object_[name].is_null();
}

const nlohmann::json& Form::at(const char* name) const {
  static const nlohmann::json kNothing;
  return has(name) ? object_[name] : kNothing;
}

double Form::number(const char* name, Range range, const char* unit) {
  const nlohmann::json& value = at(name);
  if (!value.is_number()) {
    fault(name, has(name) ? "a number, please" : "missing");
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto number = value.get<double>();
  if (!range.holds(number)) {
    fault(name, range_words(range, unit));
  }
  return number;
}

std::optional<double> Form::optional_number(const char* name, Range range, const char* unit) {
  return has(name) ? std::optional(number(name, range, unit)) : std::nullopt;
}

double Form::direction(const char* name) {
  const double degrees_value = number(name, {0.0, 360.0}, "degrees");
  return degrees_value == 360.0 ? 0.0 : degrees_value;
}

std::int32_t Form::integer(const char* name) {
  const nlohmann::json& value = at(name);
  if (!value.is_number_integer() || !(value.get<double>() >= -2147483648.0) ||
      !(value.get<double>() <= 2147483647.0)) {
    fault(name, "a whole number, please");
    return 0;
  }
  return value.get<std::int32_t>();
}

std::string Form::text(const char* name, std::size_t max_bytes, const char* what) {
  const nlohmann::json& value = at(name);
  const std::string text = value.is_string() ? value.get<std::string>() : std::string();
  if (text.empty()) {
    fault(name, fmt::format("{}, please", what));
  } else if (text.size() > max_bytes) {
    fault(name, fmt::format("at most {} letters", max_bytes));
  } else if (!is_one_line(text)) {
    fault(name, "one line of letters and figures");
  } else {
    return text;
  }
  return {};
}

int Form::choice(const char* name, std::initializer_list<std::string_view> words) {
  const nlohmann::json& value = at(name);
  const std::string given = value.is_string() ? value.get<std::string>() : std::string();
  int number = 0;
  for (const std::string_view word : words) {
    if (given == word) {
      return number;
    }
    ++number;
  }
  fault(name, "please choose");
  return -1;
}

}  // namespace quickstrip
