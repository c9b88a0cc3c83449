import { $, el, svg } from './dom.js';

const ITEMS = [['good', '', 'good'], ['caution', 'hatch-2', 'near a limit'], ['exceeded', 'hatch-3', 'above a limit'],
  ['unknown', 'hatch-0', 'not known'], ['caution', 'hatch-zone', 'zone of the IMO guidance'], ['closed', 'hatch-closed', 'below steerage speed']];

export function drawLegend() {
  $('legend').replaceChildren(...ITEMS.map(([fill, hatch, words]) => {
    const box = svg('svg', { viewBox: '0 0 26 17' }, svg('rect', { width: 26, height: 17, style: `fill:var(--${fill})` }));
    if (hatch) box.append(svg('rect', { width: 26, height: 17, fill: `url(#${hatch})` }));
    return el('li', {}, box, words);
  }));
}
