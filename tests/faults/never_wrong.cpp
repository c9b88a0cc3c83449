#include "tests/faults/never_wrong.hpp"

#include <array>
#include <cmath>
#include <memory>

#include "core/advice/advice.hpp"
#include "msgs/convert/digest.hpp"
#include "msgs/convert/own_messages.hpp"
#include "msgs/convert/text.hpp"

namespace quickstrip::faults {
namespace {

constexpr int kSea = advice_t::INPUT_SEA_STATE;
constexpr int kShip = advice_t::INPUT_OWN_SHIP;
constexpr int kLoading = advice_t::INPUT_LOADING;
constexpr double kFutureTolerance_s = 5.0;  // StaleAfter's

/// exceeded > unknown > caution > good, as core/advice/steadiness.hpp orders them.
int badness(int verdict) {
  constexpr std::array<int, 4> kOrder{2, 0, 1, 3};
  return verdict >= 0 && verdict < 4 ? kOrder[static_cast<std::size_t>(verdict)] : 4;
}

double age_s(const advice_t& advice, int input) {
  return static_cast<double>(advice.utime - advice.input_utime[input]) * 1e-6;
}

template <typename Message>
const Message* find(const std::map<Mark, Message>& sent, const advice_t& advice, int input) {
  const auto at =
      sent.find({advice.input_source_id[input], advice.input_seq[input], advice.input_utime[input]});
  return at == sent.end() ? nullptr : &at->second;
}

/// The inputs that an advice names; an empty fault when each was sent.
struct Grounds {
  const sea_state_t* sea = nullptr;
  const own_ship_t* ship = nullptr;
  const loading_t* loading = nullptr;
  std::string fault;
};

Grounds grounds_of(const advice_t& advice, const Sent& sent) {
  Grounds grounds;
  grounds.sea = find(sent.seas, advice, kSea);
  grounds.ship = find(sent.ships, advice, kShip);
  grounds.loading = find(sent.loadings, advice, kLoading);
  const bool is_default = advice.input_use[kLoading] == advice_t::USE_DEFAULT;
  if (grounds.sea == nullptr) {
    grounds.fault = "the sea that it rests on was never sent";
  } else if (grounds.ship == nullptr) {
    grounds.fault = "the own ship that it rests on was never sent";
  } else if (!is_default && grounds.loading == nullptr) {
    grounds.fault = "the loading that it rests on was never sent";
  }
  return grounds;
}

std::string age_fault(const advice_t& advice, const Promises& promises) {
  const struct {
    int input;
    double limit_s;
    const char* name;
  } kinds[] = {{kSea, promises.sea_stale_after_s, "sea"},
               {kShip, promises.own_ship_stale_after_s, "own ship"},
               {kLoading, promises.loading_stale_after_s, "loading"}};
  for (const auto& kind : kinds) {
    const int use = advice.input_use[kind.input];
    if (use == advice_t::USE_DEFAULT && kind.input == kLoading) {
      continue;
    }
    if (use != advice_t::USE_LIVE && use != advice_t::USE_RESTORED) {
      return std::string("advice without a ") + kind.name;
    }
    const double age = age_s(advice, kind.input);
    if (!(age <= kind.limit_s) || !(age >= -kFutureTolerance_s)) {
      return std::string("advice on a ") + kind.name + " of the age of " + std::to_string(age) + " s";
    }
  }
  return {};
}

/// No advice: its reason, and nothing that could be taken for advice.
std::string silence_fault(const advice_t& advice) {
  if (!get_text(advice.no_advice_text).starts_with("No advice, because ")) {
    return "no advice without a reason";
  }
  const bool says_nothing = advice.verdict == advice_t::VERDICT_UNKNOWN && advice.governing == -1 &&
                            advice.num_changes == 0 && get_text(advice.reasons_text).empty();
  return says_nothing ? "" : "no advice, and yet something is advised";
}

std::string number_fault(const advice_t& advice, const advice_t& right) {
  const bool is_same = advice.heading_deg == right.heading_deg && advice.speed_kn == right.speed_kn &&
                       advice.margin == right.margin && advice.roll_rms_deg == right.roll_rms_deg &&
                       advice.slam_probability == right.slam_probability &&
                       advice.num_criteria == right.num_criteria;
  if (!is_same) {
    return "numbers are not those of its inputs";
  }
  for (int i = 0; i < advice.num_criteria; ++i) {
    if (advice.criterion_value[i] != right.criterion_value[i]) {
      return "a criterion's value is not that of its inputs";
    }
  }
  return badness(advice.verdict) < badness(right.verdict) ? "the verdict is better than its inputs allow"
                                                          : "";
}

bool all_unknown(const grid_t& grid) {
  for (int s = 0; s < grid.num_speeds; ++s) {
    for (int h = 0; h < grid.num_headings; ++h) {
      if (grid.verdict[s][h] != grid_t::VERDICT_UNKNOWN) {
        return false;
      }
    }
  }
  return true;
}

std::string seal_fault(const advice_t& advice) {
  static std::array<std::uint8_t, kMaxMessageBytes> scratch;
  static const auto again = std::make_unique<advice_t>();
  *again = advice;
  return seal(*again, scratch) && again->digest == advice.digest ? "" : "the digest is not its own";
}

}  // namespace

bool is_good(const advice_t& advice) {
  return advice.no_advice == 0 && advice.verdict == advice_t::VERDICT_GOOD;
}

std::string fault_of(const advice_t& advice, const Sent& sent, const Promises& promises, Oracle& oracle) {
  if (!check_advice(advice).ok()) {
    return "a field is out of range";
  }
  if (std::string fault = seal_fault(advice); !fault.empty()) {
    return fault;
  }
  if (advice.source_id != promises.source_id) {
    return "from another source";
  }
  const double valid_s = static_cast<double>(advice.valid_until_utime - advice.utime) * 1e-6;
  if (!(valid_s > 0.0) || !(valid_s <= 3.0 * promises.cycle_s + 1e-3)) {
    return "valid for " + std::to_string(valid_s) + " s";
  }
  if (advice.no_advice != 0) {
    return silence_fault(advice);
  }
  if (!get_text(advice.no_advice_text).empty()) {
    return "advice, and a reason for none";
  }
  if (std::string fault = age_fault(advice, promises); !fault.empty()) {
    return fault;
  }
  const Grounds grounds = grounds_of(advice, sent);
  if (!grounds.fault.empty()) {
    return grounds.fault;
  }
  return number_fault(advice, oracle.of(*grounds.sea, *grounds.ship, grounds.loading).advice);
}

std::string fault_of(const grid_t& grid, const advice_t& advice, const Sent& sent, Oracle& oracle) {
  if (!check_grid(grid).ok()) {
    return "grid: a field is out of range";
  }
  if (grid.utime != advice.utime || grid.limits_digest != advice.limits_digest) {
    return "grid: not of its advice";
  }
  const bool may_have_cells =
      advice.no_advice == 0 || advice.no_advice == static_cast<int>(NoAdvice::kSpeedOutsideGrid);
  if (!may_have_cells) {
    return all_unknown(grid) ? "" : "grid: cells are judged without advice";
  }
  if (advice.no_advice != 0) {
    return {};
  }
  const Grounds grounds = grounds_of(advice, sent);
  if (!grounds.fault.empty()) {
    return grounds.fault;
  }
  const grid_t& right = oracle.of(*grounds.sea, *grounds.ship, grounds.loading).grid;
  if (grid.num_speeds != right.num_speeds || grid.num_headings != right.num_headings) {
    return "grid: of another size";
  }
  for (int s = 0; s < grid.num_speeds; ++s) {
    for (int h = 0; h < grid.num_headings; ++h) {
      if (grid.roll_rms[s][h] != right.roll_rms[s][h] || grid.margin[s][h] != right.margin[s][h]) {
        return "grid: a cell's numbers are not those of its inputs";
      }
      if (badness(grid.verdict[s][h]) < badness(right.verdict[s][h])) {
        return "grid: a cell is better than its inputs allow";
      }
    }
  }
  return {};
}

}  // namespace quickstrip::faults
