// Why a cell is as it is: closed (below steerage speed), a zone of the IMO guidance, motions, or both.
// Hazard bits: msgs/CHANNELS.md.
const NO_STEERAGE = 1;
const MOTIONS = 8192;
export const ZONES = [
  { bits: 4 | 8, name: 'surf-riding' },
  { bits: 16 | 32, name: 'successive waves' },
  { bits: 64, name: 'synchronous roll' },
  { bits: 128 | 256, name: 'parametric roll' },
  { bits: 512 | 1024, name: 'loss of stability' },
];
const ANY_ZONE = ZONES.reduce((bits, zone) => bits | zone.bits, 0);

export function causesOf(grid, i) {
  const hazards = grid.hazards[i];
  const zone = (hazards & ANY_ZONE) !== 0;
  const motion = (hazards & MOTIONS) !== 0 || (grid.verdict[i] >= 2 && !zone);
  return { closed: (hazards & NO_STEERAGE) !== 0, zone, motion };
}

// Where to write the name of each zone: in the middle of each patch that is large enough to be named.
const LEAST_CELLS = 24; // of some 1,800
const ALWAYS_NAMED = 150; // smaller ones only once a zone

export function zonePatches(grid) {
  const patches = [];
  const { num_speeds: speeds, num_headings: headings } = grid;
  for (const zone of ZONES) {
    const seen = new Uint8Array(speeds * headings);
    for (let start = 0; start < seen.length; ++start) {
      if (seen[start] || !(grid.hazards[start] & zone.bits) || (grid.hazards[start] & NO_STEERAGE)) continue;
      const patch = [];
      const queue = [start];
      seen[start] = 1;
      while (queue.length > 0) {
        const i = queue.pop();
        patch.push(i);
        const s = Math.floor(i / headings);
        const h = i % headings;
        for (const [ds, dh] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
          const n = (s + ds) * headings + ((h + dh + headings) % headings);
          if (s + ds < 0 || s + ds >= speeds || seen[n] || !(grid.hazards[n] & zone.bits) || (grid.hazards[n] & NO_STEERAGE)) continue;
          seen[n] = 1;
          queue.push(n);
        }
      }
      if (patch.length >= LEAST_CELLS) patches.push({ name: zone.name, cells: patch });
    }
  }
  const largest = (patch) => patches.every((other) => other.name !== patch.name || other.cells.length <= patch.cells.length);
  return patches.filter((patch) => patch.cells.length >= ALWAYS_NAMED || largest(patch));
}
