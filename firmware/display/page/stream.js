// The event stream, and the judgement whether the advisor is still speaking. The page judges by itself: no beat,
// no advice for longer than a cycle and 1.5 s, or advice whose time is over: silent. Silence is never "safe".
const BEAT_LOST_MS = 2000; // beats come twice a second
const AFTER_CYCLE_MS = 1500;

export class Stream {
  constructor(handlers) {
    this.handlers = handlers;
    this.beat = null;
    this.beatAt = -Infinity;
    if (new URLSearchParams(location.search).has('still')) this.readOnce();
    else this.open();
    setInterval(() => handlers.judge(this.silence()), 250);
  }

  async readOnce() { // for a picture: a stream never ends, and a browser that waits for its end draws nothing
    for (const name of ['beat', 'state', 'grid', 'trends']) {
      const data = await (await fetch(`/api/${name}`)).json();
      if (name === 'beat') this.takeBeat(data);
      else if (data) this.handlers[name](data);
    }
  }

  takeBeat(beat) {
    if (this.beat && this.beat.start_id !== beat.start_id) location.reload(); // the display has started anew
    this.beat = beat;
    this.beatAt = performance.now();
    this.handlers.beat(beat);
  }

  open() {
    this.source = new EventSource('/events');
    const on = (name, see) => this.source.addEventListener(name, (event) => see(JSON.parse(event.data)));
    on('beat', (beat) => this.takeBeat(beat));
    for (const name of ['state', 'grid', 'trends', 'answer']) on(name, (data) => data && this.handlers[name](data));
    this.source.addEventListener('error', () => {
      if (this.source.readyState === EventSource.CLOSED) { // refused, not only lost: the browser would not try again
        this.source.close();
        setTimeout(() => this.open(), 2000);
      }
    });
  }

  now() { // by the display's clock, in ms
    return this.beat ? this.beat.utime / 1000 + performance.now() - this.beatAt : Date.now();
  }

  // Null when all is well, else what to say.
  silence() {
    const sinceBeat = performance.now() - this.beatAt;
    if (!this.beat) return { title: 'NO ADVICE RECEIVED', text: 'Waiting for the display\'s program.', link: 'not connected' };
    if (this.beat.recorded) return null;
    if (sinceBeat > BEAT_LOST_MS) return { title: 'DISPLAY NOT CONNECTED', text: 'Its program does not answer. What is shown is old.', link: 'lost' };
    if (this.beat.advice_age_ms === null) return { title: 'NO ADVICE RECEIVED', text: 'The advisor has not been heard yet.', link: 'connected' };
    const age = this.beat.advice_age_ms + sinceBeat;
    if (age > this.beat.cycle_s * 1000 + AFTER_CYCLE_MS) return { title: 'ADVISOR SILENT', text: 'for', since: age, link: 'connected' };
    return null;
  }
}
