// Joins the parts: frames from the stream to what draws them, keys and buttons to what they do.
import { $, setText } from './dom.js';
import { Stream } from './stream.js';
import { initPolar, drawGrid, drawState, moved, chosen, select, cellPlace } from './polar.js';
import { drawVerdict, drawSilence } from './verdict.js';
import { drawChanges } from './changes.js';
import { drawTrends } from './trends.js';
import { drawMeasured } from './measured.js';
import { drawInputs } from './inputs.js';
import { drawAlerts } from './alerts.js';
import { explain, takeAnswer, setCellState } from './cell.js';
import { openSea, openLoading, openMark, openWithdraw, openClock, offsetWords, shipOffsetMin } from './entry.js';
import { initPalette } from './palette.js';
import { drawLegend, drawUnknownShare } from './legend.js';
import { clock, duration } from './words.js';

const PANELS = ['changes', 'trends', 'measured', 'inputs', 'alerts'];
let state = null;

function showPanel(name) {
  for (const panel of PANELS) {
    $(`panel-${panel}`).hidden = panel !== name;
    $(`tab-${panel}`).setAttribute('aria-selected', String(panel === name));
  }
  if (name === 'inputs' && state) drawInputs(state, timeOfAdvice(), openWithdraw);
}

// Ages are told against the advisor's clock: with a replayed log that is the log's.
const isReplayed = () => Boolean(state?.recorded || state?.health?.clock === 1);
const timeOfAdvice = () => (isReplayed() && state?.advice ? state.advice.utime / 1000 : stream.now());

function drawClock() {
  const now = timeOfAdvice();
  setText($('utc'), `${clock(now)} UTC`);
  const offset = shipOffsetMin();
  setText($('ship-time'), Number.isFinite(offset) ? `${clock(now, offset).slice(0, 5)} ship's time (${offsetWords(offset)})` : 'ship\'s time: touch to set');
}

function isOver() { // advice whose time is over, by the display's clock; a replay's time is its own
  return state?.advice && !isReplayed() && stream.now() > state.advice.valid_until_utime / 1000;
}

function judge(silence) {
  drawClock();
  const over = silence ?? (isOver() ? { title: 'ADVICE OUT OF DATE', text: 'Its time is over.', link: 'connected' } : null);
  document.body.classList.toggle('silent', over !== null);
  document.body.classList.toggle('recorded', Boolean(stream.beat?.recorded));
  setText($('link-state'), over ? over.link : stream.beat?.recorded ? 'recorded' : 'live');
  if (over) {
    const last = state?.advice ? ` Last advice ${clock(state.advice.utime / 1000)} UTC.` : '';
    setText($('silence-title'), over.title);
    setText($('silence-text'), `${over.text}${over.since ? ` ${duration(over.since / 1000)}` : ''}.${last} Do not use what is shown.`.replace('..', '.'));
    drawSilence(over);
  } else if (stream.beat?.recorded) {
    setText($('silence-title'), 'RECORDED');
    setText($('silence-text'), state?.advice ? `a moment of a log: ${new Date(state.advice.utime / 1000).toISOString().slice(0, 16).replace('T', ' ')} UTC` : '');
    if (state) drawVerdict(state);
  } else if (state) {
    drawVerdict(state);
  }
}

function takeState(newest) {
  state = newest;
  setCellState(state);
  setText($('hull-name'), state.advice?.hull || state.health?.hull || 'Quickstrip');
  setText($('profile-name'), state.advice?.profile ? `Limits: ${state.advice.profile}` : '');
  const entered = ['sea', 'loading'].filter((kind) => state.entries[kind]);
  setText($('entered'), entered.length ? `${entered.join(' and ')} entered by hand` : '');
  drawState(state);
  drawUnknownShare(state.outlook);
  drawChanges(state, (heading_deg, speed_kn) => explain({ heading_deg, speed_kn }));
  drawMeasured(state);
  drawInputs(state, timeOfAdvice(), openWithdraw);
  drawAlerts(state);
  judge(stream.silence());
  markReady();
}

// For a picture made without a hand: the page says when state and grid are drawn.
const drawnParts = new Set();
function markReady(part = 'state') {
  drawnParts.add(part);
  if (drawnParts.size === 2) requestAnimationFrame(() => { document.documentElement.dataset.ready = '1'; });
}

function explainChosen(s, h) {
  select({ s, h });
  explain(cellPlace({ s, h }));
}

function keys(event) {
  const steps = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [1, 0], ArrowDown: [-1, 0] };
  if (steps[event.key]) {
    const cell = moved(...steps[event.key]);
    if (cell) {
      const place = cellPlace(cell);
      $('polar').setAttribute('aria-description', `${place.heading_deg} degrees, ${place.speed_kn} knots`);
    }
    event.preventDefault();
  } else if (event.key === 'Enter' && chosen()) {
    explain(cellPlace(chosen()));
    event.preventDefault();
  }
}

initPalette();
drawLegend();
initPolar(explainChosen);
$('polar').addEventListener('keydown', keys);
$('open-sea').addEventListener('click', openSea);
$('open-loading').addEventListener('click', openLoading);
$('open-mark').addEventListener('click', openMark);
$('clock').addEventListener('click', () => openClock(drawClock));
for (const panel of PANELS) $(`tab-${panel}`).addEventListener('click', () => showPanel(panel));
const stream = new Stream({ judge, beat: () => {}, state: takeState, grid: (grid) => { drawGrid(grid); markReady('grid'); }, trends: drawTrends, answer: takeAnswer });
