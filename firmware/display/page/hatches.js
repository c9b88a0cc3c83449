// Verdicts without colour: good plain, caution dots, exceeded cross-hatch, unknown question marks, a zone of the
// IMO guidance bars. Marks for words: circle, triangle, crossed square, question mark.
import { svg } from './dom.js';

export function hatchDefinitions() {
  const pattern = (id, size, ...children) =>
    svg('pattern', { id, width: size, height: size, patternUnits: 'userSpaceOnUse' }, ...children);
  const stroke = (d, name) => svg('path', { d, fill: 'none', style: `stroke:var(--${name})`, 'stroke-width': 1.4, opacity: 0.75 });
  const mark = svg('text', { x: 2, y: 10, 'font-size': 11, 'font-weight': 'bold', style: 'fill:var(--ink-unknown)' });
  mark.textContent = '?';
  return svg('defs', {},
    pattern('hatch-2', 8, svg('circle', { cx: 4, cy: 4, r: 1.5, style: 'fill:var(--ink-caution)' })),
    pattern('hatch-3', 8, stroke('M0,0 L8,8 M8,0 L0,8', 'ink-exceeded')),
    pattern('hatch-0', 14, mark),
    pattern('hatch-closed', 10, stroke('M0,10 L10,0', 'line')),
    pattern('hatch-zone', 9, svg('path', { d: 'M4.5,0 V9', style: 'stroke:var(--ink-zone)', 'stroke-width': 3 })));
}

const FILL = ['unknown', 'good', 'caution', 'exceeded'];
export const fillName = (verdict) => FILL[verdict] ?? 'unknown';

// The mark that stands beside the word, in -50 ... 50.
export function verdictMark(verdict) {
  const paint = (name) => ({ style: `fill:var(--${name});stroke:currentColor`, 'stroke-width': 7 });
  const ink = { fill: 'none', style: 'stroke:currentColor', 'stroke-width': 7 };
  switch (verdict) {
    case 1: return [svg('circle', { r: 40, ...paint('good') })];
    case 2: return [svg('path', { d: 'M0,-43 L45,38 H-45 Z', ...paint('caution') }),
      svg('path', { d: 'M0,-16 V12 M0,20 V28', ...ink })];
    case 3: return [svg('rect', { x: -40, y: -40, width: 80, height: 80, ...paint('exceeded') }),
      svg('path', { d: 'M-40,-40 L40,40 M40,-40 L-40,40', ...ink })];
    default: {
      const text = svg('text', { y: 32, 'text-anchor': 'middle', 'font-size': 90, 'font-weight': 'bold', fill: 'currentColor' });
      text.textContent = '?';
      return [svg('circle', { r: 44, ...ink, 'stroke-dasharray': '12 8' }), text];
    }
  }
}
