// The words on the polar: bearings around it, speeds on the rings, names of zones. None lies under own ship's arrow,
// a number of the changes, or another.
import { svg } from './dom.js';
import { pointAt } from './geometry.js';
import { box, freest, wordsBox } from './boxes.js';
import { zonePatches } from './causes.js';

const NAMES = { 0: 'N', 90: 'E', 180: 'S', 270: 'W' };
const HALO = { stroke: 'var(--panel)', 'paint-order': 'stroke', 'pointer-events': 'none' };

function text(at, size, words, attributes) {
  const label = svg('text', { x: at.x, y: at.y + size * 0.36, 'text-anchor': 'middle', 'font-size': size, ...attributes });
  label.textContent = words;
  return label;
}

export const BEARINGS = Array.from({ length: 12 }, (_, i) => 30 * i);
const bearingWords = (b) => NAMES[b] ?? String(b).padStart(3, '0');
const bearingSize = (b) => (NAMES[b] ? 24 : 16);

export function bearingBox(bearing, top, radius) {
  const [x, y] = pointAt(bearing - top, radius + 15);
  return wordsBox(x, y, bearingWords(bearing), bearingSize(bearing));
}

export function bearingLabels(top, radius) {
  return BEARINGS.map((b) => text(bearingBox(b, top, radius), bearingSize(b), bearingWords(b),
    { id: `bearing-${b}`, fill: 'var(--dim)', 'font-weight': 'bold' }));
}

// What own ship's arrow, its line from the middle and the numbers cover.
export function shipBoxes(state, scale, top) {
  const advice = state?.advice;
  if (!advice || advice.no_advice !== 0) return [];
  const place = (heading, speed, size) => box(...pointAt(heading - top, speed), size, size);
  const r = scale.at(advice.speed_kn);
  const line = Array.from({ length: Math.ceil(r / 8) }, (_, i) => place(advice.heading_deg, 8 * i, 8));
  const numbers = (state.changes ?? []).slice(0, 4).map((c) => place(c.to_heading_deg, Math.max(scale.at(c.to_speed_kn), 12), 30));
  return [place(advice.heading_deg, r, 36), ...line, ...numbers];
}

// The speeds on one ray, the first of these that is free: between the bearings' names, so the rim is free as well.
const RAYS = [45, 135, 315, 225, 15, 75, 105, 165];

export function ringLabels(speeds, scale, taken) {
  const named = speeds.filter((v) => v > 0 && v % 6 === 0);
  const boxes = freest(RAYS.map((ray) => named.map((v) => wordsBox(...pointAt(ray, scale.at(v)), `${v} kn`, 15))), taken);
  const labels = boxes.map((at, i) => text(at, 15, `${named[i]} kn`, { ...HALO, class: 'ring-name', fill: 'var(--text)', 'stroke-width': 4 }));
  return { boxes, labels };
}

// The name of a zone on one of its cells, upright and inside the rim: the free one nearest to the middle of its patch
// (the middle itself, of a ring, lies outside it).
export function zoneLabels(grid, scale, top, radius, taken) {
  const { num_headings: headings, speed_kn: knots } = grid;
  const placed = [...taken];
  return zonePatches(grid).map(({ name, cells }) => {
    const points = cells.map((i) => pointAt((360 * (i % headings)) / headings - top, scale.at(knots[Math.floor(i / headings)])));
    const mean = [0, 1].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);
    const gap = (p) => Math.hypot(p[0] - mean[0], p[1] - mean[1]);
    const inside = ([x, y]) => {
      const at = wordsBox(x, y, name, 17);
      const room = Math.sqrt(Math.max(0, radius ** 2 - (Math.abs(y) + at.h / 2) ** 2)) - at.w / 2;
      return { ...at, x: Math.sign(x) * Math.min(Math.abs(x), Math.max(0, room)) };
    };
    const at = freest(points.sort((p, q) => gap(p) - gap(q)).map(inside), placed);
    placed.push(at);
    return text(at, 17, name, { ...HALO, class: 'zone-name', 'font-weight': 'bold', fill: 'var(--ink-zone)', 'stroke-width': 5 });
  });
}
