// The page in a real browser: one browser for all tests, each test with a bridge of its own.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/display/bridge.hpp"
#include "tests/support/web_driver.hpp"

namespace quickstrip::test {

inline constexpr int kWidth = 1280;
inline constexpr int kHeight = 800;
inline constexpr double kPixelsPerMm = 4.95;  // 1280 px over the 258.5 mm of a 12-inch screen of 16:10

// What lies on the screen at a bearing from the middle, at a radius of 17 kn.
inline constexpr const char* kCellAt = R"(
  const polar = document.getElementById('polar'), c = polar.getScreenCTM(), [bearing, knots] = arguments;
  const ring = document.querySelector(`.cell[data-speed="${knots}"][data-heading="90"]`).getBBox();
  const r = ring.x + ring.width / 2, a = bearing * Math.PI / 180;
  const p = new DOMPoint(r * Math.sin(a), -r * Math.cos(a)).matrixTransform(c);
  const cell = document.elementsFromPoint(p.x, p.y).find((e) => e.classList.contains('cell'));
  return cell ? { heading: Number(cell.dataset.heading), speed: Number(cell.dataset.speed), verdict: Number(cell.dataset.verdict),
                  cause: cell.dataset.cause, fill: getComputedStyle(cell).fill, x: p.x, y: p.y } : null;
)";

class Browser : public testing::Test {
 protected:
  static void SetUpTestSuite() { driver_ = std::make_unique<WebDriver>(kWidth, kHeight); }
  static void TearDownTestSuite() { driver_.reset(); }

  static WebDriver& driver() { return *driver_; }

  static void open(const Bridge& bridge, const std::string& query = "?palette=day") {
    driver().open(bridge.url() + query);
  }
  /// With advice and grid drawn.
  static void open_live(const Bridge& bridge, const std::string& query = "?palette=day") {
    open(bridge, query);
    ASSERT_TRUE(
        driver().wait_until("return document.documentElement.dataset.ready === '1' && "
                            "!document.body.classList.contains('silent')",
                            std::chrono::seconds(10)));
  }
  /// For looking at: QUICKSTRIP_SCREENSHOTS names a folder.
  static void keep_picture(const std::string& name) {
    if (const char* const folder = std::getenv("QUICKSTRIP_SCREENSHOTS")) {
      driver().save_screenshot(std::string(folder) + "/" + name + ".png");
    }
  }

 private:
  static inline std::unique_ptr<WebDriver> driver_;
};

}  // namespace quickstrip::test
