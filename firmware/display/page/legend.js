// What colours and hatches mean, and how much of the picture is not known.
import { $, el, setText, svg } from './dom.js';

const ITEMS = [['good', '', 'good'], ['caution', 'hatch-2', 'near a limit'], ['exceeded', 'hatch-3', 'above a limit'],
  ['unknown', 'hatch-0', 'not known'], ['caution', 'hatch-zone', 'zone of the IMO guidance'], ['closed', 'hatch-closed', 'below steerage speed']];

export function drawLegend() {
  $('legend').replaceChildren(...ITEMS.map(([fill, hatch, words]) => {
    const box = svg('svg', { viewBox: '0 0 26 17' }, svg('rect', { width: 26, height: 17, style: `fill:var(--${fill})` }));
    if (hatch) box.append(svg('rect', { width: 26, height: 17, fill: `url(#${hatch})` }));
    return el('li', {}, box, el('span', { id: `legend-${fill}-${hatch || 'plain'}` }, words));
  }));
}

export function drawUnknownShare(outlook) {
  const share = outlook?.unknown_share;
  setText($('legend-unknown-hatch-0'), share === null || share === undefined ? 'not known' : `not known: ${Math.round(100 * share)} % of the picture`);
}

