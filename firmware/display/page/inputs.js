// What the advice rests on: inputs with their ages and sources, own entries, the advisor's health, the logbook.
import { $, el, setText } from './dom.js';
import { capital, duration, sourceName, systemWords, clock } from './words.js';

const NAME = ['Sea (systems)', 'Sea (spectrum)', 'Forecast', 'Heading and speed', 'Loading', 'Measured motions'];
const USE = ['not used', 'in use', 'in use, kept from before a restart', 'the ship\'s file'];
const STATE = ['starting', 'running', 'running, no advice', 'computing for a new loading', 'stopping'];
const NOTE = ['Marked', 'Sea entered', 'Loading entered', 'Limits changed', 'Withdrawn'];

let parts = null; // made once: what is under a finger must not be exchanged each second
let entered = '';

function build(panel) {
  parts = { table: el('table'), sea: el('div'), entries: el('div'), health: el('p', { id: 'health-line' }), notes: el('div') };
  panel.replaceChildren(...Object.values(parts));
}

export function drawInputs(state, nowMs, withdraw) {
  const panel = $('panel-inputs');
  if (!parts) build(panel);
  if (panel.hidden) return;
  parts.table.replaceChildren(el('tr', {}, el('th', {}, 'Input'), el('th', {}, 'Use'), el('th', {}, 'Age'), el('th', {}, 'Source')),
    ...state.inputs.map((input) => inputRow(input, state, nowMs)));
  parts.sea.replaceChildren(...state.sea.systems.map((s) => el('p', {}, capital(systemWords(s)))), ...assumed(state).map((words) => el('p', {}, words)));
  if (entered !== JSON.stringify(state.entries)) {
    entered = JSON.stringify(state.entries);
    parts.entries.replaceChildren(...entries(state, withdraw));
  }
  const health = state.health;
  parts.health.className = health?.state === 1 ? '' : 'bad';
  setText(parts.health, health
    ? `Advisor ${health.version}: ${STATE[health.state] ?? ''}, cycle ${(health.cycle_last_s ?? 0).toFixed(2)} s of ${health.cycle_period_s} s, ${health.deadline_misses} missed of ${health.num_cycles}.`
    : 'The advisor\'s health has not been heard.');
  parts.notes.replaceChildren(...state.notes.slice(0, 6).map((note) => el('p', {}, `${clock(note.utime / 1000)} UTC ${NOTE[note.kind] ?? ''}: ${note.text} (${note.author})`)));
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

// What no input gave: said, because the advice rests on it.
function assumed({ advice, outlook }) {
  const named = (bits, names) => names.filter((_, i) => bits & (1 << i)).join(', ');
  const list = [];
  const sea = named(advice?.sea_assumptions ?? 0, ['spreading (25°)', 'shape (Bretschneider)', 'peakedness (3.3)']);
  if (sea) list.push(`Of the sea assumed: ${sea}.`);
  const uncertainty = named(outlook?.std_assumed ?? 0, ['wave height', 'period', 'direction', 'GM', 'roll damping']);
  if (uncertainty && outlook.num_members > 0) list.push(`Uncertainty assumed, for no input gives it: ${uncertainty}.`);
  if (outlook?.roll_period_low_s) list.push(`Natural roll period ${outlook.roll_period_low_s.toFixed(1)} to ${outlook.roll_period_high_s.toFixed(1)} s, ${outlook.roll_period_kind === 2 ? 'measured' : 'computed'}.`);
  return list;
}

function entries(state, withdraw) {
  return ['sea', 'loading'].filter((kind) => state.entries[kind]).map((kind) => el('div', { class: 'in-force' },
    el('span', {}, `By hand: ${state.entries[kind].words} `), el('button', { type: 'button', id: `withdraw-${kind}`, onclick: () => withdraw(kind) }, 'Withdraw')));
}
