// What to do: the changes in the advisor's order, each with what the turn itself brings.
import { $, el, svg } from './dom.js';
import { verdictMark } from './hatches.js';
import { VERDICT } from './words.js';

const KIND = ['Smallest that works', 'More change, much more margin', 'Heave to', ''];
let shown = '';

export function drawChanges(state, onChoose) {
  const key = JSON.stringify([state.advice?.seq === undefined, state.advice?.no_advice_text, state.advice?.reasons, state.changes, state.advice?.change_needed, state.advice?.none_is_good]);
  if (key === shown) return;
  shown = key;
  const panel = $('panel-changes');
  panel.replaceChildren();
  const { advice } = state;
  if (!advice) return;
  if (advice.no_advice !== 0) {
    panel.append(el('h3', {}, advice.no_advice_text));
    return;
  }
  if (advice.none_is_good) panel.append(el('h3', {}, 'No course and speed keeps all limits. The least bad:'));
  if (advice.no_change_helps) panel.append(el('h3', {}, 'No change of course or speed helps.'));
  if (!advice.change_needed) panel.append(el('h3', {}, 'No change is needed.'));
  state.changes.forEach((change, i) => panel.append(row(change, i, state.outlook?.num_members, onChoose)));
  if (advice.reasons) panel.append(el('p', { class: 'reasons' }, `Why: ${advice.reasons}`));
}

function surely(exceeded, members) {
  if (!members || exceeded === null || exceeded === undefined) return '';
  return exceeded === 0 ? `Kept in all ${members} cases within the uncertainty.` : `In ${exceeded} of ${members} cases within the uncertainty above a limit.`;
}

function row(change, i, members, onChoose) {
  const mark = svg('svg', { viewBox: '-50 -50 100 100' });
  mark.append(...verdictMark(change.verdict));
  const kind = change.kind === 0 && change.verdict >= 3 ? 'Smallest that helps' : KIND[change.kind] ?? '';
  const turn = change.turn?.text;
  const sure = surely(change.members_exceeded, members);
  const [what, ...rest] = change.text.split(': ');
  return el('div', { class: 'change clickable', onclick: () => onChoose(change.to_heading_deg, change.to_speed_kn), 'aria-label': `Change ${i + 1}, ${VERDICT[change.verdict]}` },
    mark, el('div', {}, el('b', {}, `${i + 1}  ${what}`), el('span', {}, `${kind ? `${kind}: ` : ''}${rest.join(': ')}${sure ? `${rest.join('').endsWith('…') ? '' : '.'} ${sure}` : ''}`), turn ? el('span', { class: 'turn' }, turn) : null));
}
