// Day, dusk, night: kept over a reload.
import { $ } from './dom.js';

const NAMES = ['day', 'dusk', 'night'];

export function setPalette(name) {
  const known = NAMES.includes(name) ? name : 'day';
  document.documentElement.dataset.palette = known;
  $('palette').textContent = known[0].toUpperCase() + known.slice(1);
  localStorage.setItem('palette', known);
}

export function initPalette() {
  setPalette(new URLSearchParams(location.search).get('palette') ?? localStorage.getItem('palette'));
  $('palette').addEventListener('click', () => setPalette(NAMES[(NAMES.indexOf(document.documentElement.dataset.palette) + 1) % 3]));
}
