// Why a cell is as it is: closed (below steerage speed), a zone of the IMO guidance, motions, or both.
// Hazard bits: msgs/CHANNELS.md.
const NO_STEERAGE = 1;
const ZONES = 0; // filled in by the bits of the zones

export function causesOf(grid, i) {
  const hazards = grid.hazards[i];
  const verdict = grid.verdict[i];
  const margin = grid.margin[i];
  const zone = (hazards & ZONES) !== 0;
  const motion = verdict >= 2 && (!zone || (margin >= 0 && margin < (verdict === 3 ? 100 : 134)));
  return { closed: (hazards & NO_STEERAGE) !== 0, zone, motion };
}
