#include "msgs/cli/list_option.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace quickstrip {
namespace {

constexpr std::size_t kMaxValues = 10'000;
constexpr std::size_t kMaxRows = 1'000'000;
constexpr double kStepRounding = 1e-9;  // of a step: decimals such as 0.1 are not exact

[[noreturn]] void refuse(std::string_view option, std::string_view text, std::string_view wanted) {
  throw CLI::ValidationError(std::string(option), fmt::format("{}: wanted: {}", text, wanted));
}

double parse_number(std::string_view option, std::string_view text) {
  double value = 0.0;
  const std::string_view digits = text.substr(!text.empty() && text.front() == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    refuse(option, text.empty() ? "(nothing)" : text, "a finite number, a,b,c or from:to:step");
  }
  return value;
}

std::vector<std::string_view> split(std::string_view text, char mark) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i == text.size() || text[i] == mark) {
      parts.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    }
  }
  return parts;
}

void append_range(std::string_view option, std::string_view text, std::vector<double>& values) {
  const auto parts = split(text, ':');
  if (parts.size() != 3) {
    refuse(option, text, "from:to:step");
  }
  const double from = parse_number(option, parts[0]);
  const double to = parse_number(option, parts[1]);
  const double step = parse_number(option, parts[2]);
  const double steps = (to - from) / step;
  if (!(steps >= 0.0) || step == 0.0) {
    refuse(option, text, "a step that leads from the first to the second number");
  }
  if (!(steps < static_cast<double>(kMaxValues))) {
    refuse(option, text, fmt::format("at most {} values", kMaxValues));
  }
  const auto whole = static_cast<std::size_t>(std::ceil(steps - kStepRounding));
  for (std::size_t i = 0; i < whole; ++i) {
    values.push_back(from + static_cast<double>(i) * step);
  }
  values.push_back(to);
}

double one_number(std::string_view option, std::string_view text, ListRange range) {
  const std::vector<double> values = parse_list(option, text, range);
  if (values.size() != 1) {
    refuse(option, text, "one number");
  }
  return values.front();
}

}  // namespace

std::vector<double> parse_list(std::string_view option, std::string_view text, ListRange range) {
  std::vector<double> values;
  for (const std::string_view part : split(text, ',')) {
    if (part.find(':') == std::string_view::npos) {
      values.push_back(parse_number(option, part));
    } else {
      append_range(option, part, values);
    }
  }
  if (values.size() > kMaxValues) {
    refuse(option, text, fmt::format("at most {} values", kMaxValues));
  }
  for (const double value : values) {
    const bool is_above = range.from_excluded ? value > range.from : value >= range.from;
    if (!(is_above && value <= range.to)) {
      refuse(option, fmt::format("{}", value),
             fmt::format("{}{} ... {}", range.from_excluded ? "above " : "", range.from, range.to));
    }
  }
  return values;
}

CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<double>& values, ListRange range,
                      const std::string& description) {
  const auto parse = [name, range, &values](const std::string& text) {
    values = parse_list(name, text, range);
  };
  return app.add_option_function<std::string>(name, parse, description)->type_name("LIST");
}

void refuse_too_many(const char* options, std::initializer_list<std::size_t> counts) {
  std::size_t rows = 1;
  for (const std::size_t count : counts) {  // each at most kMaxValues: no overflow for four of them
    rows *= count;
  }
  if (rows > kMaxRows) {
    refuse(options, fmt::format("{} combinations", rows), fmt::format("at most {}", kMaxRows));
  }
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, ListRange range,
                        const std::string& description) {
  const auto parse = [name, range, &value](const std::string& text) {
    value = one_number(name, text, range);
  };
  return app.add_option_function<std::string>(name, parse, description)->type_name("X");
}

CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& value, ListRange range,
                        const std::string& description) {
  const auto parse = [name, range, &value](const std::string& text) {
    value = one_number(name, text, range);
  };
  return app.add_option_function<std::string>(name, parse, description)->type_name("X");
}

}  // namespace quickstrip
