// Words beside one another: boxes on the screen by their middle, in the picture's units, and the first free place.
export const box = (x, y, w, h) => ({ x, y, w, h });

// Room for a text: bold digits are 0.56 of the size wide, letters on the average a little less; its halo around it.
export const wordsBox = (x, y, words, size) => box(x, y, 0.56 * size * words.length + 4, size + 4);

function shared(a, b) {
  const across = (a.w + b.w) / 2 - Math.abs(a.x - b.x);
  const down = (a.h + b.h) / 2 - Math.abs(a.y - b.y);
  return across > 0 && down > 0 ? across * down : 0;
}

// The first candidate (a box, or boxes that go together) that touches nothing; if there is none, the one that covers
// least. The same input, the same place.
export function freest(candidates, taken) {
  let best = null;
  let least = Infinity;
  for (const candidate of candidates) {
    const covered = [candidate].flat().reduce((sum, own) => taken.reduce((more, other) => more + shared(own, other), sum), 0);
    if (covered < least) [best, least] = [candidate, covered];
    if (least === 0) break;
  }
  return best;
}
