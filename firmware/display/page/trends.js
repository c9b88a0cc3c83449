// The last twelve hours: margin, roll, wave height. Kept by the display's program, so that a reload has them.
import { $, el, svg } from './dom.js';

const ROWS = [
  { name: 'Waves may grow to', column: 1, unit: 'times', limit: 1, least: 2, cap: 4 },
  { name: 'Roll, RMS', column: 2, unit: '°', least: 4, cap: 60 },
  { name: 'Wave height', column: 3, unit: 'm', least: 2, cap: 40 },
];

export function drawTrends({ samples }) {
  const panel = $('panel-trends');
  if (samples.length === 0) return;
  const to = samples[samples.length - 1][0];
  const hours = Math.max(1, Math.ceil((to - samples[0][0]) / 60));
  panel.replaceChildren(el('h3', {}, `Last ${hours} h (of 12 kept)`), ...ROWS.map((row) => draw(row, samples, to - hours * 60, to)));
  panel.dataset.samples = samples.length;
}

function draw({ name, column, unit, limit, least, cap }, samples, from, to) {
  const known = samples.map((s) => s[column]).filter((v) => v >= 0).map((v) => Math.min(v, cap));
  const max = Math.max(least, ...known);
  const x = (minute) => (600 * (minute - from)) / Math.max(1, to - from);
  const y = (v) => 78 - (74 * Math.min(v, cap)) / max;
  let d = '';
  let last = null;
  for (const s of samples) {
    const v = s[column];
    if (v >= 0) d += `${last !== null && s[0] - last <= 65 ? 'L' : 'M'}${x(s[0]).toFixed(1)},${y(v).toFixed(1)} h0.01 `;
    last = v >= 0 ? s[0] : null; // what is not known leaves a gap, not a line; an hourly log is joined
  }
  const picture = svg('svg', { viewBox: '0 0 600 80', preserveAspectRatio: 'none' }, svg('line', { x1: 0, x2: 600, y1: 78, y2: 78 }));
  if (limit) picture.append(svg('line', { class: 'limit', x1: 0, x2: 600, y1: y(limit), y2: y(limit) }));
  picture.append(svg('path', { d, 'stroke-linecap': 'round' }));
  const now = samples[samples.length - 1][column];
  return el('div', { class: 'trend' }, el('div', {}, name, el('br'), el('b', {}, now >= 0 ? `${now >= 99 ? 'beyond' : now.toFixed(1)} ${now >= 99 ? '' : unit}` : 'not known'), el('br'), `top ${max.toFixed(1)}`), picture);
}
