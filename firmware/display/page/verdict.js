// The verdict, large; own course and speed; how far the limit is; what governs; what to expect.
import { $, setText } from './dom.js';
import { verdictMark } from './hatches.js';
import * as words from './words.js';

let drawn = null;

function setVerdict(key, word, mark) {
  const box = $('verdict');
  if (drawn !== key) {
    drawn = key;
    box.dataset.verdict = String(mark ?? 'none');
    $('verdict-mark').replaceChildren(...verdictMark(mark));
  }
  setText($('verdict-word'), word);
}

export function drawSilence(silence) {
  if (silence) setVerdict('silent', silence.title === 'ADVISOR SILENT' ? 'SILENT' : 'NO DATA', null);
}

export function drawVerdict(state) {
  const advice = state.advice;
  if (!advice) return;
  const has = advice.no_advice === 0;
  if (has) setVerdict(`v${advice.verdict}`, words.VERDICT[advice.verdict], advice.verdict);
  else setVerdict('none', 'NO ADVICE', null);
  const ship = has ? advice : { heading_deg: state.own_ship?.heading_deg ?? null,
    speed_kn: state.own_ship?.speed_through_water_kn ?? state.own_ship?.speed_over_ground_kn ?? null };
  setText($('own-heading'), ship.heading_deg === null ? '---°' : words.degrees3(ship.heading_deg));
  setText($('own-speed'), ship.speed_kn === null ? '--.-' : ship.speed_kn.toFixed(1));
  setText($('own-caption'), advice.speed_kind === 2 ? 'Heading and speed over ground' : 'Heading and speed');
  const margin = has ? advice.margin : null;
  setText($('margin-caption'), words.marginCaption(margin));
  setText($('margin-big'), words.marginBig(margin));
  setText($('no-advice'), has ? '' : advice.no_advice_text);
  setText($('governing'), has ? governing(state) : '');
  setText($('expected'), has ? expected(state) : '');
  setText($('members'), has ? members(state.outlook) : '');
  const notes = [...advice.hazard_words, ...advice.quality_words].map((note) => note.replace(/ \((IMO|band) [^)]*\)/, ''));
  if (has && state.outlook?.better_in_s > 0) notes.unshift(`By itself this moment is ${words.verdictSentence(state.outlook.verdict_now)}; shown when it has lasted ${words.duration(state.outlook.better_in_s)} more`);
  setText($('notes-now'), has ? notes.join('. ') : '');
}

function governing(state) {
  const { advice, criteria } = state;
  if (advice.governing === null) return '';
  const criterion = criteria[advice.governing];
  const name = advice.governing_name || criterion?.name || '';
  if (!criterion || advice.governing_value === null) return name;
  const from = state.sea.systems[advice.governing_system];
  const by = from && state.sea.systems.length > 1 ? `; mostly ${words.systemName(from.kind)} from ${words.degrees3(from.dir_from_deg)}` : '';
  return `${words.capital(name)}: ${words.value(advice.governing_value, criterion.unit)}${words.statistic(criterion.statistic)}, limit ${words.value(advice.governing_limit, criterion.unit)}${by}`;
}

const EVENTS = [[9, 'slams'], [10, 'deck wet'], [11, 'propeller out']];

// The largest of the next half hour where the advisor tells it; else RMS, and it says so.
function expected(state) {
  const o = state.outlook;
  const parts = [];
  if (o && o.expected_max_roll_deg !== null) parts.push(`roll ${o.expected_max_roll_deg.toFixed(0)}°`);
  if (o && o.expected_max_pitch_deg !== null) parts.push(`pitch ${o.expected_max_pitch_deg.toFixed(0)}°`);
  for (const [quantity, name] of EVENTS) {
    const most = Math.max(...state.criteria.filter((c) => c.quantity === quantity && c.expected !== null).map((c) => c.expected));
    if (most >= 1) parts.push(`${name} ${Math.round(most)}×`);
  }
  if (parts.length > 0) return `Largest likely in ${words.duration(o.expect_s)}: ${parts.join(', ')}`;
  return state.advice.roll_rms_deg === null ? '' : `Roll ${state.advice.roll_rms_deg.toFixed(1)}° RMS (single rolls go well beyond)`;
}

function members(o) {
  if (!o || o.num_members === 0 || o.present_exceeded === null) return '';
  return `In ${o.present_exceeded} of ${o.num_members} cases within the uncertainty a limit is exceeded.`;
}
