#include "sim/seaway/stated.hpp"

#include <memory>
#include <span>

#include "core/advice/nordforsk.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip::seaway {
namespace {

// Some MB.
struct Solved {
  TransferWorkspace work;
  TransferFunctions transfer;
  IncidentWaves waves;
  SeaEnergy energy;
  CellResponse cell;
};

}  // namespace

Result<Stated> stated(const Hull& hull, const LoadedHull& loaded, const Watch& watch, const SeaView& sea,
                      Heading heading, double speed, std::uint32_t quality) {
  const Result<Criteria> criteria = nordforsk_merchant(hull);
  if (!criteria) {
    return criteria.error();
  }
  const auto s = std::make_unique<Solved>();
  if (const Status status = solve_transfer_functions(loaded, std::span(&speed, 1), s->work, s->transfer);
      !status) {
    return status.error();
  }
  const std::span<const double> omega(s->transfer.omega.data(), s->transfer.num_frequencies);
  const Status placed = sea.measured != nullptr ? place_on_grid(*sea.measured, omega, s->energy)
                                                : place_on_grid(*sea.systems, omega, s->energy);
  if (!placed) {
    return placed.error();
  }
  const CriteriaChannels channels = bind_criteria(*criteria, watch);
  list_incident_waves(s->transfer, watch, s->waves);
  GridInputs inputs{s->transfer, watch, s->waves, *criteria, channels, s->energy};
  inputs.lpp = hull.lpp;
  inputs.quality = quality;
  if (const Status status = respond(inputs, heading, speed, s->cell); !status) {
    return status.error();
  }
  Stated out;
  out.quantities.assign(s->cell.quantities.begin(), s->cell.quantities.end());
  out.quality = s->cell.cell.quality;
  out.roll_damping = static_cast<double>(s->cell.cell.roll_damping_ratio) * s->transfer.critical_roll_damping;
  return out;
}

}  // namespace quickstrip::seaway
