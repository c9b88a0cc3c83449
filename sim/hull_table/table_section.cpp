#include "sim/hull_table/table_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>

#include "core/base/constants.hpp"
#include "core/hull/lewis_section.hpp"
#include "sim/parent/mapped_flow.hpp"
#include "sim/parent/section_contour.hpp"
#include "sim/parent/section_flow.hpp"
#include "sim/parent/true_section.hpp"

namespace quickstrip {
namespace {

// As core/strip/loaded_hull.cpp and transfer_functions.cpp.
constexpr double kLowestNode = 0.05;  // of encounter frequencies, in sqrt(g/L)
constexpr double kHighestNode = 50.0;
constexpr double kHighestOmega = 2.2;   // of waves [rad/s], or
constexpr double kHighestFroude = 6.0;  // in sqrt(g/L)
constexpr double kBeyond = 1.05;

constexpr double kMet = 20.0;  // sqrt(g/L): see is_flagged

struct Method {
  HullSections in_use{};
  std::function<SectionFlow(double)> flow;
};

// As the program on board takes it.
Method lewis_method(const ImmersedSection& section) {
  const Result<LewisSection> form =
      hydrodynamic_lewis_section(section.breadth, section.draught, section.area);
  if (!form) {
    throw std::invalid_argument(fmt::format("no Lewis form: {}", message(form.error())));
  }
  const auto mapped = std::make_shared<const MappedSection>(mapped_section(*form));
  return {HullSections::kLewis, [mapped](double k) { return mapped->flow(k); }};
}

// A bulb that touches the waterline without breadth there, or hull above a bulb, joined on the centre plane
// alone: no single contour.
bool is_pinched(const ImmersedSection& section) {
  const auto& contour = section.contour;
  const Offset& top = contour.back();
  const auto on_centre_plane = [](const Offset& point) { return point.y == 0.0; };
  return (top.y == 0.0 && top.z == 0.0) ||
         std::any_of(contour.begin() + 1, contour.end() - 1, on_centre_plane);
}

HullSections in_table(SectionMethod method) {
  return method == SectionMethod::kLewis      ? HullSections::kLewis
         : method == SectionMethod::kCloseFit ? HullSections::kCloseFit
                                              : HullSections::kFrank;
}

Method method_for(const ImmersedSection& section, HullSections wanted) {
  if (wanted == HullSections::kLewis || is_pinched(section)) {
    return lewis_method(section);
  }
  const TrueSection own(section_contour(section),
                        wanted == HullSections::kCloseFit ? SectionMethod::kCloseFit : SectionMethod::kFrank);
  return {in_table(own.method()), [own](double k) { return own.flow(k); }};
}

OscillationValues values_of(const SectionFlow& flow) {
  OscillationValues out{};
  out[kTableA33] = flow.a33;
  out[kTableH3] = flow.h3;
  out[kTableA22] = flow.a22;
  out[kTableA24] = flow.a24;
  out[kTableA44] = flow.a44;
  out[kTableH2] = flow.h2;
  out[kTableH4] = flow.h4;
  return out;
}

WaveValues values_of(const DiffractionFactors& f) {
  return {f.heave.real(), f.heave.imag(),      f.sway.real(),
          f.sway.imag(),  f.roll_lever.real(), f.roll_lever.imag()};
}

const char* advice_for(Error error) {
  return error == Error::kDraughtAboveDeck ? "offsets up to the deck edge or lesser draughts are wanted"
                                           : message(error);
}

}  // namespace

TableNodes table_nodes(const Hull& hull) {
  TableNodes out;
  const double span = std::log(kHighestNode / kLowestNode);
  for (std::size_t i = 0; i < kHullTableOscillations; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(kHullTableOscillations - 1);
    const double omega_hat = kLowestNode * std::exp(t * span);
    out.oscillation[i] = omega_hat * omega_hat / hull.lpp;
  }
  out.highest_met = kMet * kMet / hull.lpp;
  const double gravity = hull.loading.gravity;
  const double highest = std::max(kHighestOmega, kHighestFroude * std::sqrt(gravity / hull.lpp));
  const double top = kBeyond * highest * highest / gravity;
  const double kc = 2.0 / hull.breadth;
  for (std::size_t i = 0; i < kHullTableWaves; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(kHullTableWaves - 1);
    out.wave[i] = kc * std::expm1(t * std::log1p(top / kc));
  }
  return out;
}

// One station makes a prism, so that a station out of the water, or one too low, speaks for itself.
std::optional<ImmersedSection> cut_station(const Hull& hull, std::size_t station, double level) {
  const auto prism = std::make_unique<Hull>();
  const auto cut = std::make_unique<ImmersedSections>();
  prism->lpp = hull.lpp;
  prism->loading = hull.loading;
  for (const double x : {0.0, 0.5, 1.0}) {
    Station copy = hull.stations[station];
    copy.x = x * hull.lpp;
    if (!prism->stations.push_back(copy)) {
      throw std::invalid_argument(message(Error::kTooMany));
    }
  }
  const bool minimal = hull.stations[station].is_minimal();
  Loading& loading = prism->loading;
  loading.draught_aft = minimal ? hull.stations[station].draught : level;
  loading.draught_fwd = loading.draught_aft;
  const Status status = immerse(*prism, loading, *cut);
  if (!status && status.error() != Error::kTooFewStations) {
    throw std::invalid_argument(fmt::format("station x_m = {:g}, waterline {:g} m above base: {}; {}",
                                            hull.stations[station].x, level, message(status.error()),
                                            advice_for(status.error())));
  }
  if (cut->empty()) {
    return std::nullopt;
  }
  return cut->front();
}

TableSection solve_section(const ImmersedSection& section, HullSections method, const TableNodes& nodes) {
  const Method own = method_for(section, method);
  TableSection out;
  out.method = own.in_use;
  for (std::size_t i = 0; i < kHullTableOscillations; ++i) {
    const SectionFlow flow = own.flow(nodes.oscillation[i]);
    out.is_flagged = out.is_flagged || (!flow.is_converged && nodes.oscillation[i] <= nodes.highest_met);
    out.oscillation[i] = values_of(flow);
  }
  out.wave[0].fill(values_of(DiffractionFactors{1.0, 1.0, 0.0}));
  for (std::size_t i = 1; i < kHullTableWaves; ++i) {
    const SectionFlow flow = own.flow(nodes.wave[i]);
    out.is_flagged = out.is_flagged || !flow.is_converged;
    for (std::size_t d = 0; d < kHullTableDirections; ++d) {
      out.wave[i][d] =
          values_of(diffraction_factors(flow, nodes.wave[i], std::sqrt(kHullTableSinSquared[d])));
    }
  }
  return out;
}

}  // namespace quickstrip
