// What the advice rests on: inputs with their ages and sources, own entries, the advisor's health, the logbook.
import { $, el } from './dom.js';
import { duration, sourceName, systemWords, clock } from './words.js';

const NAME = ['Sea (systems)', 'Sea (spectrum)', 'Forecast', 'Heading and speed', 'Loading', 'Measured motions'];
const USE = ['not used', 'in use', 'in use, kept from before a restart', 'the ship\'s file'];
const STATE = ['starting', 'running', 'running, no advice', 'computing for a new loading', 'stopping'];
const NOTE = ['Marked', 'Sea entered', 'Loading entered', 'Limits changed', 'Withdrawn'];

export function drawInputs(state, nowMs, withdraw) {
  const panel = $('panel-inputs');
  if (panel.hidden && panel.childElementCount > 0) return;
  const rows = state.inputs.map((input) => inputRow(input, state, nowMs));
  const health = state.health;
  panel.replaceChildren(
    el('table', {}, el('tr', {}, el('th', {}, 'Input'), el('th', {}, 'Use'), el('th', {}, 'Age'), el('th', {}, 'Source')), ...rows),
    ...state.sea.systems.map((s) => el('p', {}, systemWords(s))),
    ...entries(state, nowMs, withdraw),
    el('p', { id: 'health-line', class: health?.state === 1 ? '' : 'bad' }, health
      ? `Advisor ${health.version}: ${STATE[health.state] ?? ''}, cycle ${(health.cycle_last_s ?? 0).toFixed(2)} s of ${health.cycle_period_s} s, ${health.deadline_misses} missed of ${health.num_cycles}.`
      : 'The advisor\'s health has not been heard.'),
    ...state.notes.slice(0, 6).map((note) => el('p', {}, `${clock(note.utime / 1000)} UTC ${NOTE[note.kind] ?? ''}: ${note.text} (${note.author})`)));
}

function inputRow(input, state, nowMs) {
  const age = input.utime ? Math.max(0, nowMs / 1000 - input.utime / 1e6) : input.age_s;
  const stale = age !== null && age !== undefined && input.stale_after_s && age > input.stale_after_s;
  const refused = input.refused > 0 ? `, ${input.refused} refused${input.last_refusal ? ` (${input.last_refusal})` : ''}` : '';
  const source = input.input < 2 && input.use ? sourceName(state.sea.source_kind) : '';
  return el('tr', {}, el('td', {}, NAME[input.input]), el('td', {}, USE[input.use] ?? ''),
    el('td', { class: stale ? 'stale' : '' }, age === null || age === undefined || input.use === 3 ? '–' : duration(age)),
    el('td', {}, `${source}${input.source_id ? ` (no. ${input.source_id})` : ''}${refused}`));
}

function entries(state, nowMs, withdraw) {
  return ['sea', 'loading'].filter((kind) => state.entries[kind]).map((kind) => {
    const entry = state.entries[kind];
    const left = duration((entry.valid_until_utime / 1000 - nowMs) / 1000);
    return el('div', { class: 'in-force' }, `${entry.words} Ends in ${left}. `, el('button', { type: 'button', id: `withdraw-${kind}`, onclick: () => withdraw(kind) }, 'Withdraw'));
  });
}
