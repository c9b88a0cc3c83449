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

// Beside the arrow, inside the picture, and not over one another.
function labels(systems, top) {
  const placed = [];
  return systems.map((system) => {
    let [x, y] = pointAt(system.dir_from_deg - top, 316);
    const side = x > 0 ? -1 : 1; // into the picture's corner, away from the edge
    x = Math.max(-326, Math.min(326, x));
    const above = y < 0;
    y = Math.max(-322, Math.min(318, y + (above ? -36 : 34)));
    while (placed.some((p) => Math.abs(p.y - y) < 42 && Math.abs(p.x - x) < 150)) y += above ? 44 : -44;
    placed.push({ x, y });
    const anchor = Math.abs(x) < 90 ? 'middle' : side > 0 ? 'start' : 'end';
    const text = svg('text', { class: 'wave-label', x, y, 'text-anchor': anchor, 'font-size': 19, 'font-weight': 'bold',
      style: 'fill:var(--wave);stroke:var(--bg)', 'stroke-width': 5, 'paint-order': 'stroke' });
    const line = (words, dy) => {
      const span = svg('tspan', { x, dy });
      span.textContent = words;
      return span;
    };
    text.append(line(`from ${degrees3(system.dir_from_deg)}`, 0), line(`${one(system.hs_m)} m, ${one(system.period_s)} s`, 20));
    return text;
  });
}
