// Alerts after IMO MSC.302(87): the most urgent one in a strip, all of them in a list; acknowledge and silence.
import { $, el } from './dom.js';
import { clock } from './words.js';
import { post } from './post.js';

const PRIORITY = ['', 'EMERGENCY', 'ALARM', 'WARNING', 'CAUTION'];
const STATE = ['over', 'not acknowledged', 'silenced', 'acknowledged', 'over, not acknowledged'];
let shown = '';

const isOpen = (alert) => alert.state === 1 || alert.state === 2 || alert.state === 4;

async function ask(alert, what) {
  const { alert_id, instance, revision } = alert;
  const answer = await post('acknowledge', { alert_id, instance, revision, what });
  if (!answer.ok) shown = '';
}

function buttons(alert) {
  if (!isOpen(alert) || alert.priority === 4) return []; // a caution needs no acknowledgement
  const list = [el('button', { type: 'button', class: 'acknowledge', onclick: () => ask(alert, 'acknowledge') }, 'Acknow-', el('br'), 'ledge')];
  if (alert.state === 1) list.push(el('button', { type: 'button', class: 'silence', onclick: () => ask(alert, 'silence') }, 'Silence'));
  return list;
}

export function drawAlerts({ alerts }) {
  const key = JSON.stringify(alerts);
  if (key === shown) return;
  shown = key;
  const open = alerts.filter((a) => isOpen(a) && a.priority < 4);
  const strip = $('alert-strip');
  strip.hidden = open.length === 0;
  strip.classList.toggle('flash', open.some((a) => a.state === 1));
  if (open.length > 0) strip.replaceChildren(el('div', {}, el('b', {}, `${PRIORITY[open[0].priority]}: ${open[0].title}`), ` ${open[0].text.split(';')[0]}`), ...buttons(open[0]));
  $('tab-alerts').textContent = alerts.length > 0 ? `Alerts (${alerts.length})` : 'Alerts';
  $('tab-alerts').classList.toggle('urgent', open.length > 0);
  const rows = alerts.map((alert) => el('tr', {}, el('td', {}, el('b', {}, PRIORITY[alert.priority])),
    el('td', {}, `${clock(alert.raised_utime / 1000)} UTC ${alert.title}. ${alert.text}`), el('td', {}, STATE[alert.state]), el('td', {}, ...buttons(alert))));
  $('panel-alerts').replaceChildren(alerts.length === 0 ? el('p', {}, 'No alerts.') : el('table', {}, ...rows));
}
