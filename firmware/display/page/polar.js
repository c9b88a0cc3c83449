// The polar of verdicts: heading is direction, speed is radius. North up, or the ship's head up.
import { $, svg, setText } from './dom.js';
import { pointAt, segment, speedScale } from './geometry.js';
import { hatchDefinitions, fillName } from './hatches.js';
import { drawWaves } from './waves.js';
import { causesOf } from './causes.js';
import { bearingLabels, ringLabels, shipBoxes, zoneLabels } from './labels.js';

export const RADIUS = 262;
const view = { grid: null, state: null, headUp: false, selected: null, cells: [], scale: null, shape: '' };
const layers = {};

export function initPolar(onChoose) {
  const root = $('polar');
  root.append(hatchDefinitions());
  layers.rose = svg('g', { id: 'rose' });
  for (const name of ['cells', 'zones', 'rings']) {
    layers[name] = svg('g', { id: `layer-${name}` });
    layers.rose.append(layers[name]);
  }
  layers.ship = svg('g', { id: 'layer-ship' }); // turned like the rose, but above the labels
  layers.labels = svg('g', { id: 'layer-labels' });
  layers.waves = svg('g', { id: 'layer-waves' });
  root.append(layers.rose, layers.labels, layers.ship, layers.waves);
  layers.cells.addEventListener('click', (event) => {
    const cell = event.target.closest('[data-s]');
    if (cell) onChoose(Number(cell.dataset.s), Number(cell.dataset.h));
  });
  $('orientation').addEventListener('click', () => {
    view.headUp = !view.headUp;
    turn();
  });
  turn();
}

// Degrees by which the picture is turned: what lies at this bearing is on top.
export function topBearing() {
  const heading = view.state?.own_ship?.heading_deg ?? view.state?.advice?.heading_deg;
  return view.headUp && heading !== undefined && heading !== null ? heading : 0;
}

function turn() {
  const top = topBearing();
  for (const layer of [layers.rose, layers.ship]) layer.setAttribute('transform', `rotate(${-top})`);
  $('orientation').replaceChildren(view.headUp ? 'Head' : 'North', document.createElement('br'), 'up');
  drawLabels(top);
  drawWaves(layers.waves, view.state?.sea?.systems ?? [], top, RADIUS);
}

function drawLabels(top) {
  const labels = bearingLabels(top, RADIUS);
  if (view.grid && view.scale) {
    const ship = shipBoxes(view.state, view.scale, top);
    const rings = ringLabels(view.grid.speed_kn, view.scale, ship);
    labels.push(...rings.labels, ...zoneLabels(view.grid, view.scale, top, RADIUS, [...ship, ...rings.boxes]));
  }
  layers.labels.replaceChildren(...labels);
}

// The elements are made once for a shape of grid, then only their classes change.
function build(grid) {
  view.shape = `${grid.num_headings}:${grid.speed_kn.join()}`;
  view.scale = speedScale(grid.speed_kn, RADIUS);
  view.cells = [];
  const half = 180 / grid.num_headings;
  layers.cells.replaceChildren();
  layers.zones.replaceChildren();
  for (let s = 0; s < grid.num_speeds; ++s) {
    for (let h = 0; h < grid.num_headings; ++h) {
      const bearing = (360 * h) / grid.num_headings;
      const d = segment(bearing - half, bearing + half, view.scale.inner(s), view.scale.outer(s));
      const fill = svg('path', { d, class: 'cell', 'data-s': s, 'data-h': h, 'data-heading': bearing, 'data-speed': grid.speed_kn[s] });
      const hatch = svg('path', { d, class: 'hatch', 'pointer-events': 'none' });
      const zone = svg('path', { d, 'pointer-events': 'none', fill: 'none' });
      view.cells.push({ fill, hatch, zone, key: '' });
      layers.cells.append(fill, hatch);
      layers.zones.append(zone);
    }
  }
  layers.rings.replaceChildren(
    ...grid.speed_kn.filter((v) => v > 0 && v % 6 === 0).map((v) => svg('circle', { r: view.scale.at(v), fill: 'none', stroke: 'var(--line)', 'stroke-width': 1, 'pointer-events': 'none' })),
    svg('circle', { r: RADIUS, fill: 'none', stroke: 'var(--text)', 'stroke-width': 1.5, 'pointer-events': 'none' }));
}

function paint(cell, grid, i) {
  const verdict = grid.verdict[i];
  const causes = causesOf(grid, i);
  const key = `${verdict}${causes.closed}${causes.motion}${causes.zone}`;
  if (cell.key === key) return;
  cell.key = key;
  cell.fill.style.fill = `var(--${causes.closed ? 'closed' : fillName(verdict)})`;
  cell.fill.dataset.verdict = verdict;
  cell.fill.dataset.cause = causes.closed ? 'closed' : causes.zone ? (causes.motion ? 'both' : 'zone') : causes.motion ? 'motion' : 'none';
  const hatch = causes.closed ? 'closed' : verdict === 0 ? '0' : causes.motion ? String(verdict) : '';
  cell.hatch.setAttribute('fill', hatch ? `url(#hatch-${hatch})` : 'none');
  cell.zone.setAttribute('fill', causes.zone ? 'url(#hatch-zone)' : 'none');
}

export function drawGrid(grid) {
  view.grid = grid.num_speeds > 0 ? grid : null;
  if (!view.grid) {
    layers.cells.replaceChildren();
    layers.zones.replaceChildren();
    view.shape = '';
    return;
  }
  if (view.shape !== `${grid.num_headings}:${grid.speed_kn.join()}`) {
    build(grid);
  }
  view.cells.forEach((cell, i) => paint(cell, grid, i));
  drawLabels(topBearing());
  drawShip();
}

export function drawState(state) {
  view.state = state;
  turn();
  drawShip();
  setText($('sea-height'), state.sea.hs_m === null ? '' : `${state.sea.hs_m.toFixed(1)} m`);
}

// Own heading and speed, the changes as numbers, the chosen cell.
function drawShip() {
  const parts = [];
  const advice = view.state?.advice;
  if (view.scale && advice && advice.no_advice === 0) {
    const top = topBearing();
    const r = view.scale.at(advice.speed_kn);
    const [x, y] = pointAt(advice.heading_deg, r);
    parts.push(svg('path', { d: `M0,0 L${x},${y}`, stroke: 'var(--own)', 'stroke-width': 3.5, 'pointer-events': 'none' }),
      svg('path', { id: 'own-ship', d: 'M0,-19 L11,15 L0,8 L-11,15 Z', transform: `translate(${x},${y}) rotate(${advice.heading_deg})`, fill: 'var(--own)', stroke: 'var(--own-edge)', 'stroke-width': 2.5, 'pointer-events': 'none' }));
    (view.state.changes ?? []).slice(0, 4).forEach((change, i) => {
      const [cx, cy] = pointAt(change.to_heading_deg, Math.max(view.scale.at(change.to_speed_kn), 12));
      const number = svg('text', { y: 7, 'text-anchor': 'middle', 'font-size': 20, 'font-weight': 'bold', fill: 'var(--own-edge)' });
      number.textContent = String(i + 1);
      parts.push(svg('g', { class: 'change-mark', transform: `translate(${cx},${cy}) rotate(${top})`, 'pointer-events': 'none' },
        svg('circle', { r: 14, fill: 'var(--own)', stroke: 'var(--own-edge)', 'stroke-width': 2 }), number));
    });
  }
  if (view.selected && view.scale) {
    const { s, h } = view.selected;
    const half = 180 / view.grid.num_headings;
    const bearing = (360 * h) / view.grid.num_headings;
    parts.push(svg('path', { id: 'selected', d: segment(bearing - half, bearing + half, view.scale.inner(s), view.scale.outer(s)), fill: 'none', stroke: 'var(--focus)', 'stroke-width': 5, 'pointer-events': 'none' }));
  }
  layers.ship.replaceChildren(...parts);
}

// The chosen cell by keyboard: from the ship's own when none is chosen yet.
export function select(cell) {
  view.selected = cell;
  if (view.grid) drawShip();
}

export function moved(ds, dh) {
  if (!view.grid) return null;
  const { num_speeds: speeds, num_headings: headings, speed_kn: knots } = view.grid;
  let cell = view.selected;
  if (!cell) {
    const advice = view.state?.advice;
    const near = knots.reduce((best, v, s) => (Math.abs(v - (advice?.speed_kn ?? 0)) < Math.abs(knots[best] - (advice?.speed_kn ?? 0)) ? s : best), 0);
    cell = { s: near, h: Math.round(((advice?.heading_deg ?? 0) / 360) * headings) % headings };
  } else {
    cell = { s: Math.max(0, Math.min(speeds - 1, cell.s + ds)), h: (cell.h + dh + headings) % headings };
  }
  select(cell);
  return cell;
}

export const chosen = () => view.selected;
export function cellPlace({ s, h }) {
  return { heading_deg: (360 * h) / view.grid.num_headings, speed_kn: view.grid.speed_kn[s] };
}
