#include "sim/picture/polar_side_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include "core/hazard/hazard_bits.hpp"
#include "sim/picture/governing_regions.hpp"
#include "sim/picture/message_text.hpp"

namespace quickstrip {
namespace {

constexpr double kLeft = 37.6;  // of the panel, in the plane's units
constexpr double kLineHeight = 1.75;

/// Labels written from the top down.
class Panel {
 public:
  explicit Panel(double top) : y_(top) {}

  void title(std::string_view text) {
    y_ -= 0.9;
    put(text, "left font ':Bold,15' tc rgb '#222222'");
  }
  void line(std::string_view text, std::string_view colour = "#222222") {
    put(text, fmt::format("left font ',13.5' tc rgb '{}'", colour));
  }
  void key(std::string_view symbol, std::string_view text) {
    label(kLeft + 1.3, symbol, "center font ':Bold,15' tc rgb '#3A2A1A'");
    label(kLeft + 3.4, text, "left font ',13.5' tc rgb '#222222'");
    y_ -= kLineHeight;
  }
  void box(const char* colour, std::string_view text, int pattern = 0, const char* hatch = "#808080") {
    const std::string place =
        fmt::format("from {:.2f},{:.2f} to {:.2f},{:.2f}", kLeft, y_ - 0.55, kLeft + 2.6, y_ + 0.75);
    text_ += fmt::format("set object rect {} fs solid border lc rgb '#444444' fc rgb '{}'\n", place, colour);
    if (pattern != 0) {
      text_ +=
          fmt::format("set object rect {} fs transparent pattern {} border lc rgb '#444444' fc rgb '{}'\n",
                      place, pattern, hatch);
    }
    label(kLeft + 3.4, text, "left font ',13.5' tc rgb '#222222'");
    y_ -= kLineHeight;
  }
  void paragraph(std::string_view text, std::size_t max_lines) {
    const std::string lines = wrapped(text, 40, max_lines);
    const auto num = 1 + std::count(lines.begin(), lines.end(), '\n');
    std::size_t from = 0;
    for (std::ptrdiff_t i = 0; i < num; ++i) {
      const std::size_t to = std::min(lines.find('\n', from), lines.size());
      line(std::string_view(lines).substr(from, to - from));
      from = to + 1;
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void put(std::string_view text, std::string_view style) {
    label(kLeft, text, style);
    y_ -= kLineHeight;
  }
  void label(double x, std::string_view text, std::string_view style) {
    text_ += fmt::format("set label {} at {:.2f},{:.2f} noenhanced front {}\n", quoted(text), x, y_, style);
  }

  double y_;
  std::string text_;
};

std::string verdict_line(const PolarPicture& picture) {
  const advice_t& advice = picture.advice;
  if (advice.no_advice != 0) {
    return message_text(advice.no_advice_text);
  }
  constexpr std::array<const char*, 4> kWords{"not known", "good", "caution", "limits exceeded"};
  return fmt::format("Heading {:03.0f}° at {:.1f} kn: {}", advice.heading_deg, advice.speed_kn,
                     kWords[static_cast<std::size_t>(std::clamp<int>(advice.verdict, 0, 3))]);
}

void add_changes(Panel& panel, const advice_t& advice) {
  if (advice.no_advice != 0 || advice.change_needed == 0) {
    return;
  }
  panel.title(advice.none_is_good != 0 ? "No course is good; least bad" : "Smallest changes");
  for (int i = 0; i < std::min<int>(advice.num_changes, kNumShownChanges); ++i) {
    panel.paragraph(fmt::format("{}  {}", i + 1, message_text(advice.change_text[i])), 3);
  }
  if (advice.no_change_helps != 0) {
    panel.line("No change of course or speed helps.");
  }
}

void add_letters(Panel& panel, const PolarPicture& picture) {
  std::set<int> shown;
  for (const GoverningRegion& region : governing_regions(picture.grid)) {
    shown.insert(region.criterion);
  }
  const std::vector<std::string> letters = criterion_letters(picture.limits);
  if (shown.empty() || letters.empty()) {
    return;
  }
  panel.title("What governs");
  for (const int criterion : shown) {
    if (static_cast<std::size_t>(criterion) < letters.size()) {
      panel.key(letters[static_cast<std::size_t>(criterion)], message_text(picture.limits.name[criterion]));
    }
  }
}

}  // namespace

std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    out += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  }
  return out + "'";
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t max_lines) {
  std::string out;
  std::size_t column = 0;
  std::size_t lines = 1;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::size_t word = end - at;
    if (column > 0 && column + 1 + word > width) {
      if (lines == max_lines) {
        return out + " …";
      }
      out += '\n';
      ++lines;
      column = 0;
    } else if (column > 0) {
      out += ' ';
      ++column;
    }
    out += text.substr(at, word);
    column += word;
    at = end + 1;
  }
  return out;
}

double unknown_share(const grid_t& grid) {
  int num_cells = 0;
  int num_unknown = 0;
  for (int s = 0; s < grid.num_speeds; ++s) {
    for (int h = 0; h < grid.num_headings; ++h) {
      const bool counts = (grid.hazards[s][h] & kHazardNoSteerage) == 0;
      num_cells += counts ? 1 : 0;
      num_unknown += counts && grid.verdict[s][h] == grid_t::VERDICT_UNKNOWN ? 1 : 0;
    }
  }
  return num_cells > 0 ? static_cast<double>(num_unknown) / num_cells : -1.0;
}

std::string side_panel(const PolarPicture& picture) {
  const advice_t& advice = picture.advice;
  std::string text;
  const auto heading = [&text](double y, std::string_view what, std::string_view style) {
    text += fmt::format("set label {} at -35.2,{:.2f} noenhanced front left {}\n", quoted(what), y, style);
  };
  heading(34.6, message_text(advice.hull_name), "font ':Bold,24' tc rgb '#111111'");
  double tp = 0.0;
  double highest = 0.0;
  for (const PictureWave& wave : picture.waves) {
    tp = wave.hs_m > highest ? wave.tp_s : tp;
    highest = std::max(highest, wave.hs_m);
  }
  heading(32.2, picture.time, "font ',16' tc rgb '#333333'");
  heading(30.5, fmt::format("Sea: Hs {:.1f} m, Tp {:.1f} s", picture.hs_m, tp),
          "font ',16' tc rgb '#333333'");
  Panel panel(35.5);
  panel.title("Now");
  panel.paragraph(verdict_line(picture), 4);
  panel.paragraph(message_text(advice.reasons_text), 5);
  add_changes(panel, advice);
  add_letters(panel, picture);
  panel.title("Heading: direction, speed: radius");
  panel.box(kVerdictColours[1], "good: inside every limit");
  panel.box(kVerdictColours[2], "caution: near a limit");
  panel.box(kVerdictColours[3], "exceeded");
  panel.box(kFarExceededColour, "exceeded by far (also at 2/3 Hs)");
  const double unknown = unknown_share(picture.grid);
  panel.box(kVerdictColours[0],
            unknown < 0.0 ? "not known" : fmt::format("not known: {:.1f} % of the cells", 100.0 * unknown),
            5);
  panel.box("#FBFAF7", "below steerage speed", 4);
  panel.box(kVerdictColours[2], "IMO zone only, motions in limits", kZoneOnlyPattern, kZoneOnlyColour);
  panel.box(kVerdictColours[2], "IMO zone and motions", kZoneAndMotionsPattern, kZoneAndMotionsColour);
  panel.line("No hatch: motions only.");
  panel.line("Blue arrows: the waves come from there;", "#12436D");
  panel.line("their breadth tells the height.", "#12436D");
  panel.line("White: the ship now. 1, 2, 3: changes.", "#1B3FAB");
  text += panel.text();
  return text;
}

}  // namespace quickstrip
