// In a real browser: palettes, sizes, one column on a phone.
#include "tests/display/browser.hpp"

#include <cmath>

namespace quickstrip::test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

// Every colour that is on the page, as the browser computed it.
constexpr const char* kColours = R"(
  const found = new Set();
  for (const e of document.querySelectorAll('body, body *')) {
    const s = getComputedStyle(e);
    if (e.closest('[hidden]') || s.display === 'none') continue;
    for (const p of ['color', 'backgroundColor', 'borderTopColor', 'outlineColor', 'fill', 'stroke']) found.add(s[p]);
  }
  return [...found].filter((c) => c.startsWith('rgb')).map((c) => c.match(/[\d.]+/g).map(Number)).filter((c) => c.length < 4 || c[3] > 0);
)";

double luminance(const json& rgb) {  // relative, sRGB
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(rgb[0].get<double>() / 255.0) + 0.7152 * linear(rgb[1].get<double>() / 255.0) +
         0.0722 * linear(rgb[2].get<double>() / 255.0);
}

TEST_F(Browser, NightIsDimRedAndAmberOnBlackWithNoWhiteAnywhere) {
  Bridge bridge;
  bridge.display().mailbox().put(warning_at(utime_now()));
  open_live(bridge, "?palette=night");
  keep_picture("live_night");
  EXPECT_EQ(driver().run("return getComputedStyle(document.body).backgroundColor"), "rgb(0, 0, 0)");
  for (const char* const dialog : {"", "#open-sea", "#open-loading", "#open-mark"}) {
    if (*dialog != '\0') {
      driver().click(dialog);
      keep_picture("night_" + std::string(dialog + 6));
    }
    const json colours = driver().run(kColours);
    EXPECT_GT(colours.size(), 8U);
    for (const json& colour : colours) {
      EXPECT_LT(luminance(colour), 0.32) << dialog << colour;
      EXPECT_LE(colour[2].get<double>(), colour[0].get<double>()) << dialog << colour;  // nothing bluish
      EXPECT_LE(colour[2].get<double>(), 70.0) << dialog << colour;
    }
    if (*dialog != '\0') {
      driver().press(key::kEscape);
    }
  }
}

TEST_F(Browser, PalettesFollowTheButtonAndAreKept) {
  Bridge bridge;
  open_live(bridge);
  const json day = driver().run("return getComputedStyle(document.body).backgroundColor");
  driver().click("#palette");
  EXPECT_EQ(driver().text("#palette"), "Dusk");
  const json dusk = driver().run("return getComputedStyle(document.body).backgroundColor");
  EXPECT_NE(day, dusk);
  keep_picture("live_dusk");
  driver().click("#palette");
  EXPECT_EQ(driver().run("return document.documentElement.dataset.palette"), "night");
  open_live(bridge, "");
  EXPECT_EQ(driver().run("return document.documentElement.dataset.palette"), "night");
  driver().click("#palette");
  EXPECT_EQ(driver().run("return getComputedStyle(document.body).backgroundColor"), day);
}

TEST_F(Browser, LargestFactsAreReadAtThreeMetresAndTargetsFitAFinger) {
  Bridge bridge;
  open_live(bridge);
  const json heights = driver().run(R"(
    const context = document.createElement('canvas').getContext('2d');
    return ['verdict-word', 'own-heading', 'own-speed', 'margin-big'].map((id) => {
      const s = getComputedStyle(document.getElementById(id));
      context.font = `${s.fontWeight} ${s.fontSize} ${s.fontFamily}`;
      return context.measureText('x').actualBoundingBoxAscent;
    }))");
  for (const json& height : heights) {
    EXPECT_GE(height.get<double>() / kPixelsPerMm, 7.9);  // "about 8 mm": the font's hinting may take a tenth
  }
  const json small = driver().run(R"(
    return [...document.querySelectorAll('button')].filter((b) => b.offsetParent).map((b) => [b.id, b.getBoundingClientRect()])
      .filter(([, r]) => Math.min(r.width, r.height) < 15 * arguments[0]).map(([id, r]) => `${id} ${r.width}x${r.height}`))",
                                  {kPixelsPerMm});
  EXPECT_EQ(small, json::array());
  const json beyond = driver().run(R"(
    return ['verdict-word', 'own-speed', 'margin-big', 'utc', 'tab-alerts', 'link-state'].filter((id) => {
      const r = document.getElementById(id).getBoundingClientRect();
      return r.right > innerWidth || r.bottom > innerHeight || r.left < 0 || r.top < 0; }))");
  EXPECT_EQ(beyond, json::array());
}

TEST_F(Browser, FallsToOneColumnOnAPhone) {
  Bridge bridge;
  driver().resize(390, 844);
  open_live(bridge);
  keep_picture("live_phone");
  EXPECT_LE(driver().run("return document.documentElement.scrollWidth - innerWidth"), 0);
  driver().resize(kWidth, kHeight);
}

}  // namespace
}  // namespace quickstrip::test
