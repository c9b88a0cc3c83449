// Wave systems as arrows outside the polar: from where they come, pointing with their travel, to the middle.
import { svg } from './dom.js';
import { pointAt } from './geometry.js';
import { degrees3, one } from './words.js';

const OUTER = 340;
const INNER = 290;

export function drawWaves(layer, systems, top) {
  layer.replaceChildren(...systems.map((system) => arrow(system, top)), ...labels(systems, top));
}

// Drawn as if from the top, then turned to where it comes from. Broader for higher waves.
function arrow(system, top) {
  const half = Math.min(13, 4 + 1.1 * system.hs_m);
  const d = `M${-half},${-OUTER} H${half} V${-INNER - 20} H${half + 10} L0,${-INNER + 4} L${-half - 10},${-INNER - 20} H${-half} Z`;
  return svg('path', { class: 'wave', d, 'data-dir-from': system.dir_from_deg, transform: `rotate(${system.dir_from_deg - top})`,
    style: 'fill:var(--wave);stroke:var(--bg)', 'stroke-width': 2 });
}

// Beside the arrow, inside the picture, and not over one another: at the top and bottom to the right or left of it,
// at the sides above or below; on the lower left above, for the legend is below.
const EDGE = 328;
const WIDTH = 125;

function place(system, top) {
  const [x, y] = pointAt(system.dir_from_deg - top, 316);
  if (Math.abs(x) < 170) {
    const side = x + 26 + WIDTH > EDGE ? -1 : 1;
    return { x: x + 26 * side, y: y > 0 ? 316 : -322, anchor: side > 0 ? 'start' : 'end' };
  }
  const above = y < 0 || (x < 0 && y > 120);
  return { x: Math.sign(x) * EDGE, y: y + (above ? -46 : 38), anchor: x > 0 ? 'end' : 'start' };
}

function labels(systems, top) {
  const placed = [];
  return systems.map((system) => {
    const at = place(system, top);
    const collides = (p) => Math.abs(p.y - at.y) < 42 && Math.abs(p.x - at.x) < WIDTH;
    for (let i = 0; i < systems.length && placed.some(collides); ++i) at.y += at.y < 0 ? 44 : -44;
    placed.push(at);
    const text = svg('text', { class: 'wave-label', x: at.x, y: at.y, 'text-anchor': at.anchor, 'font-size': 19, 'font-weight': 'bold',
      style: 'fill:var(--wave);stroke:var(--bg)', 'stroke-width': 5, 'paint-order': 'stroke' });
    const line = (words, dy) => {
      const span = svg('tspan', { x: at.x, dy });
      span.textContent = words;
      return span;
    };
    text.append(line(`from ${degrees3(system.dir_from_deg)}`, 0), line(`${one(system.hs_m)} m, ${one(system.period_s)} s`, 20));
    return text;
  });
}
