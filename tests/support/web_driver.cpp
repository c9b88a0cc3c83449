#include "tests/support/web_driver.hpp"

#include <fcntl.h>
#include <httplib.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

namespace quickstrip::test {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds kStartPatience{60};                          // a loaded machine
constexpr const char* kElementKey = "element-6066-11e4-a52e-4f735466cecf";  // of the protocol

constexpr std::string_view kStarted = "started successfully on port ";

json value_of(const httplib::Result& result, const std::string& what) {
  if (!result) {
    throw std::runtime_error("chromedriver does not answer: " + what + ": " +
                             httplib::to_string(result.error()));
  }
  const json body = json::parse(result->body, nullptr, false);
  if (result->status != 200 || !body.is_object()) {
    throw std::runtime_error("chromedriver: " + what + ": " + result->body.substr(0, 600));
  }
  return body.value("value", json());
}

/// The port that chromedriver names on its standard output.
int port_from(int output) {
  std::string said;
  const auto until = std::chrono::steady_clock::now() + kStartPatience;
  while (std::chrono::steady_clock::now() < until) {
    pollfd waited{output, POLLIN, 0};
    if (poll(&waited, 1, 500) <= 0) {
      continue;
    }
    char bytes[512];
    const ssize_t got = read(output, bytes, sizeof(bytes));
    if (got <= 0) {
      break;
    }
    said.append(bytes, static_cast<std::size_t>(got));
    const std::size_t at = said.find(kStarted);
    if (at != std::string::npos && said.find('\n', at) != std::string::npos) {
      return std::atoi(said.c_str() + at +
                       kStarted.size());  // NOLINT(cert-err34-c): 0 is refused by the caller
    }
  }
  throw std::runtime_error("chromedriver did not start: " + said);
}

json options_of(const std::filesystem::path& profile, int width, int height) {
  const json args = {"--headless",
                     "--no-sandbox",
                     "--disable-gpu",
                     "--disable-quic",
                     "--no-first-run",
                     "--disable-background-networking",
                     "--disable-component-update",
                     "--disable-sync",
                     "--disable-dev-shm-usage",
                     "--hide-scrollbars",
                     "--window-size=" + std::to_string(width) + "," + std::to_string(height),
                     "--user-data-dir=" + profile.string()};
  return {{"capabilities", {{"alwaysMatch", {{"goog:chromeOptions", {{"args", args}}}}}}}};
}

}  // namespace

void WebDriver::start_driver() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw std::runtime_error("no pipe");
  }
  driver_ = fork();
  if (driver_ == 0) {
    setpgid(0, 0);  // the browser's processes end with the driver's
    dup2(ends[1], STDOUT_FILENO);
    const int nothing = ::open("/dev/null", O_RDWR);
    dup2(nothing, STDERR_FILENO);
    execlp("chromedriver", "chromedriver", "--port=0", static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  try {
    port_ = port_from(ends[0]);
  } catch (...) {
    close(ends[0]);
    end_driver();
    throw;
  }
  close(ends[0]);
}

void WebDriver::end_driver() {
  if (driver_ > 0) {
    kill(-driver_, SIGKILL);
    waitpid(driver_, nullptr, 0);
    driver_ = -1;
  }
}

WebDriver::WebDriver(int width, int height) {
  std::string name = (std::filesystem::temp_directory_path() / "quickstrip_browser.XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("no folder for the browser's profile");
  }
  profile_ = name;
  start_driver();
  session_ = "/session";
  try {
    const json begun = post("", options_of(profile_, width, height));
    session_ += "/" + begun.value("sessionId", std::string());
    resize(width, height);
  } catch (...) {
    end_driver();
    throw;
  }
}

WebDriver::~WebDriver() {
  httplib::Client client("127.0.0.1", port_);
  client.set_read_timeout(5);
  client.Delete(session_);  // ends the browser
  end_driver();
  std::error_code ignored;
  for (int i = 0; i < 10 && std::filesystem::exists(profile_, ignored); ++i) {  // it may still be writing
    std::filesystem::remove_all(profile_, ignored);
  }
}

json WebDriver::post(const std::string& path, const json& body) {
  httplib::Client client("127.0.0.1", port_);
  client.set_read_timeout(kStartPatience);
  return value_of(client.Post(session_ + path, body.dump(), "application/json"), path);
}

json WebDriver::get(const std::string& path) {
  httplib::Client client("127.0.0.1", port_);
  client.set_read_timeout(kStartPatience);
  return value_of(client.Get(session_ + path), path);
}

void WebDriver::open(const std::string& url) {
  post("/url", {{"url", url}});
}

json WebDriver::run(const std::string& script, const json& arguments) {
  return post("/execute/sync", {{"script", script}, {"args", arguments}});
}

std::string WebDriver::element(const std::string& css) {
  return post("/element", {{"using", "css selector"}, {"value", css}}).value(kElementKey, std::string());
}

void WebDriver::click(const std::string& css) {
  post("/element/" + element(css) + "/click", json::object());
}

void WebDriver::click_at(double x, double y) {
  const json moves = {
      {{"type", "pointerMove"}, {"duration", 0}, {"x", std::lround(x)}, {"y", std::lround(y)}},
      {{"type", "pointerDown"}, {"button", 0}},
      {{"type", "pointerUp"}, {"button", 0}}};
  post("/actions", {{"actions",
                     {{{"type", "pointer"},
                       {"id", "finger"},
                       {"parameters", {{"pointerType", "touch"}}},
                       {"actions", moves}}}}});
}

void WebDriver::type(const std::string& css, const std::string& text) {
  const std::string field = "/element/" + element(css);
  post(field + "/clear", json::object());
  post(field + "/value", {{"text", text}});
}

void WebDriver::press(const std::string& key) {
  const json strokes = {{{"type", "keyDown"}, {"value", key}}, {{"type", "keyUp"}, {"value", key}}};
  post("/actions", {{"actions", {{{"type", "key"}, {"id", "keys"}, {"actions", strokes}}}}});
}

std::string WebDriver::text(const std::string& css) {
  return run("return document.querySelector(arguments[0]).textContent", {css}).get<std::string>();
}

// The window's own frame is added by the browser: what counts is the page's size. A page takes its new size a
// little after the window has.
void WebDriver::resize(int width, int height) {
  constexpr int kWidestFrame = 300;
  int frame_width = 0;
  int frame_height = 0;
  for (int i = 0; i < 40; ++i) {
    post("/window/rect", {{"width", width + frame_width}, {"height", height + frame_height}});
    std::this_thread::sleep_for(std::chrono::milliseconds(i < 2 ? 0 : 50));
    const json inner = run("return [innerWidth, innerHeight]");
    const int missing_width = width - inner[0].get<int>();
    const int missing_height = height - inner[1].get<int>();
    if (missing_width == 0 && missing_height == 0) {
      return;
    }
    // More than a frame is a page that has not followed yet.
    if (std::abs(missing_width) <= kWidestFrame && std::abs(missing_height) <= kWidestFrame) {
      frame_width = std::clamp(frame_width + missing_width, 0, kWidestFrame);
      frame_height = std::clamp(frame_height + missing_height, 0, kWidestFrame);
    }
  }
  throw std::runtime_error("the page does not take its size");
}

void WebDriver::save_screenshot(const std::filesystem::path& png) {
  const auto text = get("/screenshot").get<std::string>();
  std::string bytes;
  unsigned int bits = 0;
  int num_bits = 0;
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (const char c : text) {  // base64
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) {
      continue;
    }
    bits = (bits << 6U | static_cast<unsigned int>(digit)) & 0xFFFFU;
    num_bits += 6;
    if (num_bits >= 8) {
      num_bits -= 8;
      bytes += static_cast<char>(static_cast<unsigned char>(bits >> static_cast<unsigned int>(num_bits)));
    }
  }
  std::ofstream(png, std::ios::binary) << bytes;
}

bool WebDriver::wait_until(const std::string& script, std::chrono::milliseconds patience) {
  const auto until = std::chrono::steady_clock::now() + patience;
  do {
    if (run(script) == json(true)) {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  } while (std::chrono::steady_clock::now() < until);
  return false;
}

}  // namespace quickstrip::test
