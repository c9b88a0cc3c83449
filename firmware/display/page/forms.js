// Fields with their faults beside them, the confirmation that reads back, and the officer's name kept.
import { el } from './dom.js';
import { post } from './post.js';

export const authorKept = () => localStorage.getItem('author') ?? '';

export function field(name, label, attributes = {}) {
  const id = `${attributes.prefix ?? ''}${name}`.replaceAll('.', '-');
  delete attributes.prefix;
  const input = el('input', { id, name, inputmode: 'decimal', autocomplete: 'off', ...attributes });
  return el('label', { class: `field${attributes.wide ? ' wide' : ''}` }, label, input, el('span', { class: 'error', id: `${id}-error`, role: 'alert' }));
}

export function choice(name, label, options) {
  const id = name.replaceAll('.', '-');
  const select = el('select', { id, name }, ...options.map(([value, text]) => el('option', { value }, text)));
  return el('label', { class: 'field' }, label, select, el('span', { class: 'error', id: `${id}-error`, role: 'alert' }));
}

export const authorField = () => field('author', 'Your name', { value: authorKept(), inputmode: 'text', maxlength: 31, wide: true });

// A number, null when empty; what is no number goes as text, and the program says what is wrong.
export function number(dialog, name) {
  const text = dialog.querySelector(`[name="${name}"]`).value.trim().replace(',', '.');
  if (text === '') return null;
  return Number.isFinite(Number(text)) ? Number(text) : text;
}

export function showErrors(dialog, errors) {
  for (const place of dialog.querySelectorAll('.error, .form-error')) place.textContent = '';
  let first = null;
  for (const { field: told, text } of errors ?? []) {
    const name = told.replace(/^systems\.(\d+)/, (_, i) => `systems.${dialog.rows?.[i] ?? i}`); // empty rows are not sent
    const input = name ? dialog.querySelector(`[name="${name}"]`) : null;
    const place = input ? dialog.querySelector(`#${input.id}-error`) : dialog.querySelector('.form-error');
    if (place) place.textContent = place.textContent ? `${place.textContent}; ${text}` : text;
    first ??= input;
  }
  first?.focus();
}

// Step one: judged and read back. Step two: confirmed, and sent as it was read.
export function runEntry(dialog, kind, collect, back) {
  const send = async () => {
    const data = collect();
    localStorage.setItem('author', data.author ?? '');
    const answer = await post(kind, data);
    if (!answer.ok) {
      showErrors(dialog, answer.errors);
      return;
    }
    showErrors(dialog, []);
    const form = [...dialog.children];
    const error = el('p', { class: 'form-error', role: 'alert' });
    const yes = el('button', { type: 'button', class: 'main', id: `${kind}-confirm`, onclick: async () => {
      const sent = await post('confirm', { ticket: answer.ticket });
      if (sent.ok) { dialog.close(); back(); } else error.textContent = sent.errors.map((e) => e.text).join('; ');
    } }, 'Yes, send');
    dialog.replaceChildren(el('h2', {}, 'Is this right?'), el('p', { class: 'read-back' }, answer.words), error,
      el('div', { class: 'buttons' }, yes, el('button', { type: 'button', onclick: () => dialog.replaceChildren(...form) }, 'Change it'),
        el('button', { type: 'button', onclick: () => dialog.close() }, 'Cancel')));
    yes.focus();
  };
  return el('div', { class: 'buttons' }, el('button', { type: 'button', class: 'main', id: `${kind}-check`, onclick: send }, 'Check'),
    el('button', { type: 'button', onclick: () => dialog.close() }, 'Cancel'));
}
