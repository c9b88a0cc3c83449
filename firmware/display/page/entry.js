// Manual entry of the sea and of the loading, marks, withdrawal, ship's time.
import { $, el } from './dom.js';
import { authorField, authorKept, choice, field, number, runEntry, showErrors } from './forms.js';
import { post } from './post.js';

const PERIODS = [['tp', 'peak (forecast)'], ['tm02', 'zero-crossing (by eye)'], ['tm01', 'mean']];
const ROWS = [['wind_sea', 'Wind sea'], ['swell', 'Swell'], ['swell', 'Second swell']];

function open(dialog, ...parts) {
  dialog.replaceChildren(...parts);
  dialog.showModal();
  dialog.querySelector('input')?.focus();
}

export function openSea() {
  const dialog = $('sea-dialog');
  const rows = ROWS.map(([, title], i) => el('fieldset', {}, el('legend', {}, title),
    field(`systems.${i}.hs_m`, 'Height [m]'), field(`systems.${i}.period_s`, 'Period [s]'),
    choice(`systems.${i}.period_kind`, 'Which period', i === 0 ? [PERIODS[1], PERIODS[0], PERIODS[2]] : PERIODS),
    field(`systems.${i}.dir_from_deg`, 'Comes FROM [°]'), field(`systems.${i}.spreading_deg`, 'Spreading [°], or empty')));
  const collect = () => {
    const used = []; // rows with anything in them, under the numbers the program will name
    ROWS.forEach(([kind], i) => {
      const at = (name) => number(dialog, `systems.${i}.${name}`);
      const system = { kind, hs_m: at('hs_m'), period_s: at('period_s'), dir_from_deg: at('dir_from_deg'), spreading_deg: at('spreading_deg'),
        period_kind: dialog.querySelector(`[name="systems.${i}.period_kind"]`).value };
      if (system.hs_m !== null || system.period_s !== null || system.dir_from_deg !== null) used.push([i, system]);
    });
    dialog.rows = used.map(([i]) => i);
    return { author: dialog.querySelector('[name="author"]').value, hours: number(dialog, 'hours'), systems: used.map(([, s]) => s) };
  };
  open(dialog, el('h2', {}, 'Enter the sea'), ...rows,
    el('fieldset', {}, authorField(), field('hours', 'Holds for [h]', { value: '2' })),
    el('p', { class: 'form-error', role: 'alert' }), runEntry(dialog, 'sea', collect, () => {}));
}

export function openLoading() {
  const dialog = $('loading-dialog');
  const names = [['draught_aft_m', 'Draught aft [m]'], ['draught_fwd_m', 'Draught forward [m]'], ['kg_m', 'KG [m]'],
    ['free_surface_correction_m', 'Free-surface correction [m]'], ['gm_m', 'or GM, corrected [m]'], ['measured_roll_period_s', 'Measured roll period [s]']];
  const collect = () => ({ author: dialog.querySelector('[name="author"]').value, hours: number(dialog, 'hours'),
    ...Object.fromEntries(names.map(([name]) => [name, number(dialog, name)])) });
  open(dialog, el('h2', {}, 'Enter the loading'), el('p', {}, 'What is left empty stays as in the ship\'s file.'),
    el('fieldset', {}, ...names.map(([name, label]) => field(name, label))),
    el('fieldset', {}, authorField(), field('hours', 'Holds for [h]', { value: '24' })),
    el('p', { class: 'form-error', role: 'alert' }), runEntry(dialog, 'loading', collect, () => {}));
}

export function openMark() {
  const dialog = $('mark-dialog');
  const send = async () => {
    const author = dialog.querySelector('[name="author"]').value;
    localStorage.setItem('author', author);
    const answer = await post('mark', { author, text: dialog.querySelector('[name="text"]').value });
    if (answer.ok) dialog.close();
    else showErrors(dialog, answer.errors);
  };
  open(dialog, el('h2', {}, 'Mark this moment'),
    el('fieldset', {}, field('text', 'What you saw or did', { inputmode: 'text', maxlength: 150, wide: true }), authorField()),
    el('p', { class: 'form-error', role: 'alert' }),
    el('div', { class: 'buttons' }, el('button', { type: 'button', class: 'main', id: 'mark-send', onclick: send }, 'Put into the logbook'),
      el('button', { type: 'button', onclick: () => dialog.close() }, 'Cancel')));
}

export function openWithdraw(kind) {
  const dialog = $('mark-dialog');
  const consequence = kind === 'sea' ? 'The advisor then uses another source of the sea, or says that it has none.' : 'The advisor then uses the loading of the ship\'s file.';
  const send = async () => {
    const answer = await post('withdraw', { kind, author: dialog.querySelector('[name="author"]').value });
    if (answer.ok) dialog.close();
    else showErrors(dialog, answer.errors);
  };
  open(dialog, el('h2', {}, `Withdraw the ${kind} entered by hand?`), el('p', {}, consequence), el('fieldset', {}, authorField()),
    el('p', { class: 'form-error', role: 'alert' }),
    el('div', { class: 'buttons' }, el('button', { type: 'button', class: 'main', id: 'withdraw-send', onclick: send }, 'Withdraw'),
      el('button', { type: 'button', onclick: () => dialog.close() }, 'Keep it')));
}

export const shipOffsetMin = () => Number(localStorage.getItem('ship-offset-min') ?? NaN);

export function openClock(redraw) {
  const dialog = $('clock-dialog');
  const words = el('p', { class: 'read-back' });
  const step = (minutes) => {
    const now = Number.isFinite(shipOffsetMin()) ? shipOffsetMin() : 0;
    localStorage.setItem('ship-offset-min', String(Math.max(-720, Math.min(840, now + minutes))));
    show();
    redraw();
  };
  const show = () => { words.textContent = offsetWords(Number.isFinite(shipOffsetMin()) ? shipOffsetMin() : 0); };
  show();
  open(dialog, el('h2', {}, 'Ship\'s time'), words, el('div', { class: 'buttons' },
    el('button', { type: 'button', onclick: () => step(-30) }, '− 30 min'), el('button', { type: 'button', onclick: () => step(30) }, '+ 30 min'),
    el('button', { type: 'button', class: 'main', onclick: () => dialog.close() }, 'Done')));
}

export function offsetWords(minutes) {
  const sign = minutes < 0 ? '−' : '+';
  const m = Math.abs(minutes);
  return `UTC ${sign} ${Math.floor(m / 60)}:${String(m % 60).padStart(2, '0')}`;
}
