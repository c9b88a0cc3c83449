// Wave systems as arrows outside the polar: from where they come, pointing with their travel, to the middle.
import { svg } from './dom.js';
import { pointAt } from './geometry.js';
import { box, freest } from './boxes.js';
import { BEARINGS, bearingBox } from './labels.js';
import { degrees3, one } from './words.js';

const OUTER = 340;
const INNER = 290;

export function drawWaves(layer, systems, top, radius) {
  layer.replaceChildren(...systems.map((system) => arrow(system, top)), ...labels(systems, top, radius));
}

// Drawn as if from the top, then turned to where it comes from. Broader for higher waves.
function arrow(system, top) {
  const half = Math.min(13, 4 + 1.1 * system.hs_m);
  const d = `M${-half},${-OUTER} H${half} V${-INNER - 20} H${half + 10} L0,${-INNER + 4} L${-half - 10},${-INNER - 20} H${-half} Z`;
  return svg('path', { class: 'wave', d, 'data-dir-from': system.dir_from_deg, transform: `rotate(${system.dir_from_deg - top})`,
    style: 'fill:var(--wave);stroke:var(--bg)', 'stroke-width': 2 });
}

// Along the picture's edge, as near to the arrow as is free: of the arrows, the bearings, the circle, other labels and
// the corners, where the button and the significant height are.
const EDGE = { x: 356, y: 348 };
const LABEL = { w: 92, h: 62 };
const CORNERS = [box(-300, -295, 116, 110), box(275, -310, 166, 80)];
const TURNS = Array.from({ length: 90 }, (_, i) => [2 * i, -2 * i]).flat();

function arrowBoxes(system, top) {
  return [[300, 46], [315, 34], [330, 30]].map(([r, size]) => box(...pointAt(system.dir_from_deg - top, r), size, size));
}

function place(bearing, turns, radius, taken) {
  const room = { x: EDGE.x - LABEL.w / 2, y: EDGE.y - LABEL.h / 2 };
  const boxes = turns.map((turn) => {
    const [x, y] = pointAt(bearing + turn, 1);
    const out = Math.min(room.x / Math.abs(x), room.y / Math.abs(y));
    return box(x * out, y * out, LABEL.w, LABEL.h);
  });
  const nearest = (at) => Math.hypot(Math.max(0, Math.abs(at.x) - at.w / 2), Math.max(0, Math.abs(at.y) - at.h / 2));
  return freest(boxes.filter((at) => nearest(at) > radius), taken);
}

// First on the side where no other arrow is near, so that a label is not read as its neighbour's.
function turnsOf(system, systems) {
  const near = systems.map((other) => (other.dir_from_deg - system.dir_from_deg + 540) % 360 - 180).find((turn) => turn !== 0 && Math.abs(turn) < 45);
  return near === undefined ? TURNS : [...TURNS.filter((turn) => turn * near < 0 && Math.abs(turn) <= 45), ...TURNS];
}

function labels(systems, top, radius) {
  const taken = [...CORNERS, ...systems.flatMap((system) => arrowBoxes(system, top)), ...BEARINGS.map((b) => bearingBox(b, top, radius))];
  return systems.map((system) => {
    const at = place(system.dir_from_deg - top, turnsOf(system, systems), radius, taken);
    taken.push(at);
    const text = svg('text', { class: 'wave-label', x: at.x, y: at.y - 14, 'text-anchor': 'middle', 'font-size': 19, 'font-weight': 'bold',
      style: 'fill:var(--wave);stroke:var(--bg)', 'stroke-width': 5, 'paint-order': 'stroke' });
    const line = (words, dy) => {
      const span = svg('tspan', { x: at.x, dy });
      span.textContent = words;
      return span;
    };
    text.append(line(`from ${degrees3(system.dir_from_deg)}`, 0), line(`${one(system.hs_m)} m, `, 20), line(`${one(system.period_s)} s`, 20));
    return text;
  });
}
