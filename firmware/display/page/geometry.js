// Bearings on the screen: clockwise from the top; y grows downwards in SVG.
export function pointAt(bearingDeg, radius) {
  const a = (bearingDeg * Math.PI) / 180;
  return [radius * Math.sin(a), -radius * Math.cos(a)];
}

const f = (x) => x.toFixed(2);

// The ring segment from bearing b0 to b1 and radius r0 to r1; a sector when r0 is 0.
export function segment(b0, b1, r0, r1) {
  const [x0, y0] = pointAt(b0, r1);
  const [x1, y1] = pointAt(b1, r1);
  const outer = `${f(x0)},${f(y0)} A${f(r1)},${f(r1)} 0 0 1 ${f(x1)},${f(y1)}`;
  if (r0 <= 0) return `M0,0 L${outer} Z`;
  const [x2, y2] = pointAt(b1, r0);
  const [x3, y3] = pointAt(b0, r0);
  return `M${outer} L${f(x2)},${f(y2)} A${f(r0)},${f(r0)} 0 0 0 ${f(x3)},${f(y3)} Z`;
}

// Radius of a speed: a ring a speed, the lowest around the middle.
export function speedScale(speeds, radius) {
  const step = speeds.length > 1 ? speeds[1] - speeds[0] : 1;
  const from = speeds[0] - step / 2;
  const span = speeds[speeds.length - 1] + step / 2 - from;
  const at = (v) => Math.max(0, Math.min(radius, (radius * (v - from)) / span));
  const edge = (s, side) => {
    const other = speeds[s + side];
    return at(other === undefined ? speeds[s] + (side * step) / 2 : (speeds[s] + other) / 2);
  };
  return { at, inner: (s) => edge(s, -1), outer: (s) => edge(s, 1) };
}
