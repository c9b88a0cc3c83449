// Results on standard output: CSV with a header line, a dot as decimal mark and 10 significant digits,
// whatever the locale. The text is gathered and written at once when complete, so that a command that fails
// half-way prints nothing.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace quickstrip::hull_tool {

/// A finite number with 10 significant digits (no trailing zeros).
std::string number_text(double value);

class Csv {
 public:
  explicit Csv(std::string_view header) : text_(std::string(header) + "\n") {}

  Csv& add(double value) { return add(std::string_view(number_text(value))); }
  Csv& add(std::optional<double> value) { return value ? add(*value) : add(std::string_view()); }
  Csv& add(bool value) { return add(std::string_view(value ? "1" : "0")); }
  Csv& add(int value) { return add(std::string_view(std::to_string(value))); }
  Csv& add(const char* value) { return add(std::string_view(value)); }
  /// Quoted where the text holds a comma, a quote or a line break (RFC 4180).
  Csv& add(std::string_view value);
  void end_row();
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  bool row_begun_ = false;
};

/// To standard output, in one piece; InputError when it cannot be written (disk full, pipe closed).
void print_result(std::string_view text);

}  // namespace quickstrip::hull_tool
