// A real browser, driven: a headless Chromium through chromedriver's WebDriver protocol.
//
// Every failure throws std::runtime_error with the driver's words: a test that cannot drive has failed. The
// browser gets a fresh profile, talks to nobody but the page under test, and ends with this object.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace quickstrip::test {

class WebDriver {
 public:
  WebDriver(int width, int height);
  ~WebDriver();
  WebDriver(const WebDriver&) = delete;
  WebDriver& operator=(const WebDriver&) = delete;

  void open(const std::string& url);
  /// The value of a function body's `return`; `arguments` are its arguments.
  nlohmann::json run(const std::string& script, const nlohmann::json& arguments = nlohmann::json::array());
  /// As a hand would: into view, at its middle.
  void click(const std::string& css);
  void click_at(double x, double y);
  void type(const std::string& css, const std::string& text);
  /// One key, by its WebDriver code point: "\uE004" is Tab.
  void press(const std::string& key);
  std::string text(const std::string& css);
  void resize(int width, int height);
  void save_screenshot(const std::filesystem::path& png);

  /// Until the script returns true; false after `patience`.
  bool wait_until(const std::string& script, std::chrono::milliseconds patience);

 private:
  nlohmann::json post(const std::string& path, const nlohmann::json& body);
  nlohmann::json get(const std::string& path);
  std::string element(const std::string& css);
  void start_driver();
  void end_driver();

  pid_t driver_ = -1;
  int port_ = 0;
  std::filesystem::path profile_;
  std::string session_;
};

namespace key {
inline constexpr const char* kTab = "\uE004";
inline constexpr const char* kEnter = "\uE007";
inline constexpr const char* kEscape = "\uE00C";
inline constexpr const char* kLeft = "\uE012";
inline constexpr const char* kUp = "\uE013";
inline constexpr const char* kRight = "\uE014";
inline constexpr const char* kDown = "\uE015";
}  // namespace key

}  // namespace quickstrip::test
