// Predicted beside measured.
import { $, el } from './dom.js';
import { duration } from './words.js';

const STATE = ['', 'more than predicted', 'less than predicted', 'not compared'];

export function drawMeasured(state) {
  const panel = $('panel-measured');
  const comparison = state.comparison;
  if (!comparison || comparison.lines.length === 0) {
    panel.replaceChildren(el('p', {}, 'No motions are measured, so nothing stands beside the prediction.'));
    return;
  }
  const rows = comparison.lines.map((line) => el('tr', {}, el('td', {}, line.text),
    el('td', { class: line.state === 1 || line.state === 2 ? 'bad' : '' }, STATE[line.state] ?? '', line.gap_since_s ? ` for ${duration(line.gap_since_s)}` : '')));
  panel.replaceChildren(
    el('h3', { class: comparison.confidence === 2 ? 'bad' : '' }, comparison.confidence === 2 ? 'Confidence lowered: measured and predicted differ.' : 'Predicted beside measured'),
    el('table', {}, ...rows));
}
