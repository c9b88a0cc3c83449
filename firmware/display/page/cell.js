// One course and speed explained: the grid's own figures at once, every quantity when the advisor has answered.
import { $, el, svg } from './dom.js';
import { verdictMark } from './hatches.js';
import { post } from './post.js';
import * as words from './words.js';

const ASK_AGAIN_MS = 2500; // of two questions within a cycle the advisor answers the later
const TIMES = 3;
let asked = null; // query_id
let latest = null;
let state = null;

export const setCellState = (newest) => { state = newest; };

export async function explain(place) {
  const dialog = $('cell-dialog');
  dialog.replaceChildren(el('h2', {}, `${words.degrees3(place.heading_deg)} at ${one(place.speed_kn)} kn`));
  if (!dialog.open) dialog.showModal();
  latest = place;
  await ask(place, TIMES);
}

const one = (x) => x.toFixed(1);

async function ask(place, times) {
  const answer = await post('query', place);
  if (latest !== place) return; // another cell meanwhile
  if (!answer.ok) {
    draw(place, null, answer.errors[0].text);
    return;
  }
  asked = answer.query_id;
  draw(place, answer.cell, asked ? 'The advisor is being asked for every figure …' : 'A recorded moment: the advisor cannot be asked for more.');
  if (asked && times > 1) setTimeout(() => latest === place && asked === answer.query_id && $('cell-dialog').open && ask(place, times - 1), ASK_AGAIN_MS);
}

export function takeAnswer(response) {
  if (!asked || response.query_id !== asked || !$('cell-dialog').open) return;
  asked = null;
  draw(latest, response, response.refusal ? `Not answered: ${response.refusal}.` : '');
}

function draw(place, cell, note) {
  const mark = svg('svg', { viewBox: '-50 -50 100 100' });
  mark.append(...verdictMark(cell?.verdict));
  const parts = [el('div', { class: 'head' }, mark, el('h2', {}, `${words.degrees3(place.heading_deg)} at ${one(place.speed_kn)} kn: ${cell ? words.verdictSentence(cell.verdict) : ''}`))];
  if (cell) parts.push(...why(cell), cell.lines ? figures(cell) : gridFigures(cell));
  if (note) parts.push(el('p', { class: 'note' }, note));
  const close = el('button', { type: 'button', class: 'main', onclick: () => $('cell-dialog').close() }, 'Close');
  parts.push(el('div', { class: 'buttons' }, close));
  $('cell-dialog').replaceChildren(...parts);
  $('cell-dialog').dataset.answered = String(Boolean(cell?.lines));
  close.focus();
}

function why(cell) {
  const criterion = cell.governing !== null ? state?.criteria[cell.governing] : null;
  const system = cell.governing_system !== null ? state?.sea.systems[cell.governing_system] : null;
  const list = [el('p', { class: 'margin' }, words.marginWords(cell.margin))];
  if (criterion) {
    const by = system ? `, most by the ${words.systemWords(system)}` : '';
    list.push(el('p', {}, `What governs: ${criterion.name}${by}.`));
  }
  const notes = [...cell.hazard_words, ...cell.quality_words];
  if (notes.length > 0) list.push(el('p', { class: 'bad' }, notes.join('. ')));
  return list;
}

function gridFigures(cell) {
  const row = (name, text) => (text === null ? null : el('tr', {}, el('td', {}, name), el('td', {}, text)));
  const p = (x) => (x === null ? null : words.percent(x));
  return el('table', {}, row('Roll (RMS)', cell.roll_rms_deg === null ? null : `${cell.roll_rms_deg.toFixed(1)}°`),
    row('Vertical acceleration, bridge (RMS)', cell.bridge_vertical_rms_m_s2 === null ? null : words.value(cell.bridge_vertical_rms_m_s2, 2)),
    row('Slamming, of waves met', p(cell.slam_probability)), row('Slams', cell.slams_per_hour === null ? null : words.value(cell.slams_per_hour, 4)),
    row('Water on deck, of waves met', p(cell.wetness_probability)),
    row('Speed lost to the waves', cell.speed_loss_kn === null ? null : `${cell.speed_loss_kn.toFixed(1)} kn`));
}

function figures(cell) {
  const systems = state?.sea.systems ?? [];
  const head = ['', 'Where', 'RMS', 'Significant', 'Period', 'Of waves met', 'An hour', ...systems.map((s) => `from ${words.degrees3(s.dir_from_deg)}`), 'Limit'];
  const rows = cell.lines.map((line) => {
    const criterion = line.criterion !== null ? state?.criteria[line.criterion] : null;
    return el('tr', {}, el('td', {}, words.quantityName(line.quantity)), el('td', {}, line.place === 'G' ? 'centre of gravity' : line.place),
      el('td', {}, words.value(line.rms, line.unit)), el('td', {}, words.value(line.significant, line.unit)),
      el('td', {}, line.tm02_s ? `${line.tm02_s.toFixed(1)} s` : ''), el('td', {}, line.probability === null ? '' : `${words.percent(line.probability)}${line.quantity === 12 ? ' of people' : ''}`),
      el('td', {}, line.per_hour === null ? '' : one(line.per_hour)),
      ...systems.map((_, i) => el('td', {}, line.shares[i] === null || line.shares[i] === undefined ? '' : `${Math.round(100 * line.shares[i])} %`)),
      el('td', {}, criterion ? `${words.value(criterion.limit, criterion.unit)}${words.statistic(criterion.statistic)}` : ''));
  });
  return el('table', { class: 'figures' }, el('tr', {}, ...head.map((h) => el('th', {}, h))), ...rows);
}
