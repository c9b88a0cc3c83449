// In a real browser: palettes, sizes, one column on a phone.
#include "tests/display/browser.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace quickstrip::test {
namespace {

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

// Ids of facts that do not lie whole on the screen.
constexpr const char* kBeyondTheScreen = R"(
  return ['verdict-word', 'own-speed', 'margin-big', 'utc', 'tab-alerts', 'link-state'].filter((id) => {
    const r = document.getElementById(id).getBoundingClientRect();
    return r.right > innerWidth || r.bottom > innerHeight || r.left < 0 || r.top < 0; });
)";

// Buttons below 15 mm; the argument: pixels a millimetre.
constexpr const char* kSmallButtons = R"(
  return [...document.querySelectorAll('button')].filter((b) => b.offsetParent).map((b) => [b.id, b.getBoundingClientRect()])
    .filter(([, r]) => Math.min(r.width, r.height) < 15 * arguments[0]).map(([id, r]) => `${id} ${r.width}x${r.height}`);
)";

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
  EXPECT_EQ(driver().run(kSmallButtons, {kPixelsPerMm}), json::array());
  EXPECT_EQ(driver().run(kBeyondTheScreen), json::array());
}

TEST_F(Browser, NothingIsCutOffOnASquareScreenAndWhatToDoIsSeen) {
  Bridge bridge;
  driver().resize(1024, 768);
  open_live(bridge);
  keep_picture("live_square");
  EXPECT_EQ(driver().run(kBeyondTheScreen), json::array());
  EXPECT_EQ(driver().run(kSmallButtons, {1024.0 / 304.0}),
            json::array());  // a screen of 15 inches, 304 mm wide
  EXPECT_GE(driver().run("return document.getElementById('panels').clientHeight").get<int>(), 150);
  driver().resize(kWidth, kHeight);
}

// Pairs of words of the picture whose boxes on the screen share more than a pixel: rounding of the layout.
constexpr const char* kOverlaps = R"(
  const named = (css) => [...document.querySelectorAll(css)].map((e) => [e.textContent || e.id, e.getBoundingClientRect()]);
  const meet = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
  const waves = named('.wave-label'), inside = named('.ring-name, .zone-name'), found = [];
  if (waves.length === 0 || inside.length < 5) return ['nothing drawn'];
  const check = (one, others) => others.forEach(([name, r]) => { if (meet(one[1], r)) found.push(`${one[0]} / ${name}`); });
  waves.forEach((label) => check(label, named('#legend, #orientation, #sea-total, [id^="bearing-"], .ring-name, .zone-name')));
  inside.forEach((label, i) => check(label, [...inside.slice(i + 1), ...named('#own-ship, .change-mark')]));
  return found;
)";

TEST_F(Browser, WordsOfThePictureDoNotLieOverOneAnotherWhateverTheWavesDirection) {
  Bridge bridge;
  for (const auto& [width, height] : {std::pair{kWidth, kHeight}, {1024, 768}, {390, 844}}) {
    driver().resize(width, height);
    open_live(bridge);
    for (int dir = 0; dir < 360; dir += 45) {
      const int heading = (dir + 225) % 360;  // 045 among them, where else the speeds are written
      bridge.dir_from_deg = dir;
      bridge.heading_deg = heading;
      ASSERT_TRUE(driver().wait_until("return document.querySelector('.wave')?.dataset.dirFrom === '" +
                                          std::to_string(dir) + "' && parseInt(document.getElementById(" +
                                          "'own-heading').textContent, 10) === " + std::to_string(heading),
                                      std::chrono::seconds(3)));
      for (const char* const top : {"north up", "head up"}) {
        EXPECT_EQ(driver().run(kOverlaps), json::array())
            << width << " px, waves from " << dir << ", " << top;
        driver().click("#orientation");
      }
    }
  }
  driver().resize(kWidth, kHeight);
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
