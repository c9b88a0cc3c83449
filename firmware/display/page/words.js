// The words of the field for numbers and codes.
export const VERDICT = ['NOT KNOWN', 'GOOD', 'CAUTION', 'EXCEEDED'];
const VERDICT_SENTENCE = ['not judged', 'good', 'near a limit', 'above a limit'];
const QUANTITY = ['surge', 'sway', 'heave', 'roll', 'pitch', 'yaw', 'fore-and-aft acceleration', 'sideways acceleration',
  'vertical acceleration', 'slamming', 'water on deck', 'propeller coming out', 'motion sickness', 'loss of balance'];
const POINTS = ['N', 'NNE', 'NE', 'ENE', 'E', 'ESE', 'SE', 'SSE', 'S', 'SSW', 'SW', 'WSW', 'W', 'WNW', 'NW', 'NNW'];
const PERIOD = ['peak', 'mean', 'zero-crossing'];
const SYSTEM = ['waves', 'wind sea', 'swell'];
const SOURCE = ['', 'wave radar', 'buoy', 'forecast model', 'seen', 'entered by hand'];
const G = 9.80665;

export const verdictSentence = (v) => VERDICT_SENTENCE[v] ?? 'not judged';
export const quantityName = (q) => QUANTITY[q] ?? `quantity ${q}`;
export const systemName = (k) => SYSTEM[k] ?? 'waves';
export const periodName = (k) => PERIOD[k] ?? '';
export const sourceName = (k) => SOURCE[k] ?? '';
export const degrees3 = (d) => `${String(Math.round(d) % 360).padStart(3, '0')}°`;
export const point = (d) => POINTS[Math.round(d / 22.5) % 16];
export const one = (x) => (x === null || x === undefined ? '–' : x.toFixed(1));

export function percent(p) {
  const x = 100 * p;
  return x >= 10 ? `${x.toFixed(0)}\u00a0%` : x >= 0.1 || x === 0 ? `${x.toFixed(1)}\u00a0%` : 'below 0.1\u00a0%';
}

// UNIT_...: 0 m, 1 degrees, 2 m/s2, 3 probability, 4 per hour, 5 share of people, 6 per minute
export function value(x, unit) {
  if (x === null || x === undefined) return 'not computed';
  switch (unit) {
    case 0: return `${x.toFixed(1)}\u00a0m`;
    case 1: return `${x.toFixed(1)}°`;
    case 2: return `${(x / G).toFixed(3)}\u00a0g`;
    case 3: return percent(x);
    case 4: return `${x >= 10 ? x.toFixed(0) : x.toFixed(1)}\u00a0an\u00a0hour`;
    case 5: return `${percent(x)} of people sick`;
    case 6: return `${x.toFixed(2)}\u00a0a\u00a0minute`;
    default: return x.toPrecision(3);
  }
}

// STATISTIC_...: 0 RMS, 1 significant, 2 probability; the others are in the unit's words
export const statistic = (s) => [' (RMS)', ' (significant)', ' of waves', ''][s] ?? '';

// Margin: the factor by which wave height may grow before a limit is reached.
export function marginCaption(m) {
  if (m === null || m === undefined) return 'Distance from the limits';
  if (m >= 3) return 'Limit reached if waves grow to';
  return m >= 1 ? 'Limit reached if waves grow' : 'Waves must fall by';
}

export function marginBig(m) {
  if (m === null || m === undefined) return '?';
  if (m >= 9.95) return '10 ×+';
  if (m >= 3) return `${m.toFixed(1)} ×`;
  return m >= 1 ? `${Math.floor((m - 1) * 100)} %` : `${Math.ceil((1 - m) * 100)} %`;
}

export function marginWords(m) {
  if (m === null || m === undefined) return 'How far the limits are is not known.';
  if (m >= 99) return 'No limit is in reach in any sea of this kind.';
  if (m >= 3) return `Limit reached only if waves grow to ${m.toFixed(1)} times their height.`;
  if (m >= 1) return `Limit reached if waves grow ${Math.floor((m - 1) * 100)} %.`;
  return `Above a limit: waves would have to be ${Math.ceil((1 - m) * 100)} % lower.`;
}

export function duration(s) {
  if (s === null || s === undefined || s < 0) return 'never';
  if (s < 120) return `${Math.floor(s)} s`;
  if (s < 7200) return `${Math.floor(s / 60)} min`;
  if (s < 172800) return `${Math.floor(s / 3600)} h ${Math.floor((s % 3600) / 60)} min`;
  return `${Math.floor(s / 86400)} d`;
}

export function clock(utimeMs, offsetMin = 0) {
  return new Date(utimeMs + offsetMin * 60000).toISOString().slice(11, 19);
}

export function systemWords(s) {
  return `${systemName(s.kind)} ${one(s.hs_m)} m, ${one(s.period_s)} s ${periodName(s.period_kind)} period, from ${degrees3(s.dir_from_deg)}`;
}

export const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
