// Every limit with what is now and what is to be expected, and what is predicted beside what is measured.
import { $, el } from './dom.js';
import { capital, duration, statistic, value } from './words.js';

const STATE = ['', 'more than predicted', 'less than predicted', 'not compared'];
const NUMBER_OF_EVENTS = new Set([9, 10, 11, 13]); // quantities whose expected figure is a number of times

export function drawMeasured(state) {
  const panel = $('panel-measured');
  panel.replaceChildren(limits(state), ...measured(state.comparison));
}

function limits({ criteria, outlook }) {
  const ahead = outlook?.expect_s ? `Largest in ${duration(outlook.expect_s)}` : '';
  const rows = criteria.map((c) => el('tr', {}, el('td', {}, capital(c.name)),
    el('td', { class: c.value !== null && c.value >= c.limit ? 'bad' : '' }, c.watched ? `${value(c.value, c.unit)}${c.value === null ? '' : statistic(c.statistic)}` : 'not watched'),
    el('td', {}, value(c.limit, c.unit)), el('td', {}, expected(c))));
  return el('table', { id: 'limits-table' }, el('tr', {}, ...['', 'Now', 'Limit', ahead].map((h) => el('th', {}, h))), ...rows);
}

function expected(criterion) {
  if (criterion.expected === null) return '';
  if (NUMBER_OF_EVENTS.has(criterion.quantity)) return criterion.expected < 0.5 ? 'none' : `${Math.round(criterion.expected)} times`;
  return criterion.quantity === 12 ? '' : value(criterion.expected, criterion.unit);
}

function measured(comparison) {
  if (!comparison || comparison.lines.length === 0) return [el('p', {}, 'No motions are measured: nothing stands beside the prediction.')];
  const lowered = comparison.confidence === 2;
  const rows = comparison.lines.map((line) => el('tr', {}, el('td', {}, line.text),
    el('td', { class: line.state === 1 || line.state === 2 ? 'bad' : '' }, STATE[line.state] ?? '', line.gap_since_s ? ` for ${duration(line.gap_since_s)}` : '')));
  return [el('h3', { class: lowered ? 'bad' : '' }, lowered ? 'Confidence lowered: measured and predicted differ.' : 'Predicted beside measured'), el('table', {}, ...rows)];
}
