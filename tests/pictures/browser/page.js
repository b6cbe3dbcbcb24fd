// What is looked at in a page: asked for by check.py, each function gives a list of sentences.

// Boxes of the ink of a text, in its own units, from the shapes of its glyphs; and how wide it is by nature.
const canvas = document.createElementNS('http://www.w3.org/1999/xhtml', 'canvas').getContext('2d');
const measured = new Map();
function ink(text) {
  const style = getComputedStyle(text), size = parseFloat(text.getAttribute('font-size'));
  const font = `${style.fontStyle} 200px ${style.fontFamily}`, key = font + text.textContent;
  let m = measured.get(key);
  if (!m) {
    canvas.font = font;
    m = canvas.measureText(text.textContent);
    measured.set(key, m);
  }
  const by = size / 200, x = parseFloat(text.getAttribute('x')), y = parseFloat(text.getAttribute('y'));
  const length = parseFloat(text.getAttribute('textLength')), wide = m.width * by;
  const [top, bottom] = [y - m.actualBoundingBoxAscent * by, y + m.actualBoundingBoxDescent * by];
  return { box: [x, top, x + length, bottom], wide, length, words: text.textContent };
}

function shownAs(label) {
  return label.getAttribute('aria-label') || label.textContent;
}

// The boxes of all labels of a picture where they are now, in its units.
function boxes(svg) {
  const back = svg.getScreenCTM().inverse();
  // those that fade are not seen soon, however long it takes
  const fades = label => label.closest('[style]')?.style.opacity === '0';
  const seen = [...svg.querySelectorAll('g.lab')].filter(label => !fades(label));
  return seen.map(label => {
    const all = [...label.querySelectorAll('text')].map(t => ink(t).box);
    const m = back.multiply(label.getScreenCTM());
    const box = [0, 1].map(i => Math.min(...all.map(b => b[i]))).concat([2, 3].map(i => Math.max(...all.map(b => b[i]))));
    return { name: shownAs(label), box: [box[0] + m.e, box[1] + m.f, box[2] + m.e, box[3] + m.f] };
  });
}

function overlaps(svg, by) {
  const all = boxes(svg), found = [];
  all.forEach((a, i) => all.slice(i + 1).forEach(b => {
    const [p, q] = [a.box, b.box];
    if (p[0] + by < q[2] && q[0] + by < p[2] && p[1] + by < q[3] && q[1] + by < p[3]) found.push(`${a.name} lies on ${b.name}`);
  }));
  return found;
}

function title(svg) {
  return svg.querySelector('title').textContent;
}

// Labels that lie on each other, or leave their picture.
function labels() {
  return [...document.querySelectorAll('svg.fig')].flatMap(svg => {
    const v = svg.viewBox.baseVal;
    const off = boxes(svg).filter(({ box: b }) => b[0] < v.x - 0.1 || b[1] < v.y - 0.1 || b[2] > v.x + v.width + 0.1 || b[3] > v.y + v.height + 0.1);
    return overlaps(svg, 0.05).concat(off.map(b => `${b.name} leaves the picture`)).map(fault => `${title(svg)}: ${fault}`);
  });
}

// Texts whose own width is far from the length that holds them.
function widths(share) {
  const texts = [...document.querySelectorAll('svg.fig text')].map(ink).filter(t => t.words.trim() && t.length > 0.02);
  const wrong = texts.filter(t => Math.abs(t.wide / t.length - 1) > share);
  return { count: texts.length, most: Math.max(0, ...texts.map(t => Math.abs(t.wide / t.length - 1))),
    wrong: wrong.map(t => `${t.words} is ${t.wide.toFixed(2)} mm wide and held to ${t.length}`) };
}

// What is wider than the page.
function overflow() {
  const page = document.documentElement, wide = page.scrollWidth - page.clientWidth;
  return wide > 0 ? [`the page is ${wide} px wider than the window`] : [];
}

// The colours that are seen: of the paper, and of each kind of stroke.
function colours() {
  const rect = document.querySelector('svg.fig .bg');
  return rect ? getComputedStyle(rect).fill : '';
}

// Goes to the frame whose first number is that of some words: `crank = 8.2 deg`, `crank = 8.20°`.
function shows(words) {
  const first = said => /^(.*?) = ([−-]?[0-9.]+)/.exec(said), value = m => parseFloat(m[2].replace('−', '-'));
  const wanted = first(words);
  for (let i = 0; i < played.frames; i++) {
    played.show(i);
    const found = first(document.querySelector('.motion-values').textContent);
    if (found[1] === wanted[1] && Math.abs(value(found) - value(wanted)) < 0.06) return true;
  }
  return false;
}

// Places of the first circle of each pair, in the units of the picture.
function hinges(selector) {
  const svg = document.querySelector(selector), back = svg.getScreenCTM().inverse(), found = {};
  svg.querySelectorAll('g.pair').forEach(pair => {
    const circle = pair.querySelector('circle.h'), name = pair.getAttribute('data-name');
    if (!circle || name in found) return;
    const m = back.multiply(circle.getScreenCTM()), p = new DOMPoint(circle.getAttribute('cx'), circle.getAttribute('cy')).matrixTransform(m);
    found[name] = [p.x, p.y];
  });
  const said = svg.querySelector('desc').textContent.match(/Length scale ([0-9.]+) m per mm/);
  return { places: found, scale: said ? parseFloat(said[1]) : null };
}

// The share of pixels in which two pictures differ, both on the same paper.
async function differing(first, second, width, height) {
  const pixels = async url => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const c = document.createElement('canvas');
    [c.width, c.height] = [width, height];
    const g = c.getContext('2d', { willReadFrequently: true });
    g.fillStyle = '#fff';
    g.fillRect(0, 0, width, height);
    g.drawImage(image, 0, 0, width, height);
    return g.getImageData(0, 0, width, height).data;
  };
  const [a, b] = [await pixels(first), await pixels(second)];
  let differ = 0;
  for (let i = 0; i < a.length; i += 4) {
    if (Math.max(...[0, 1, 2].map(k => Math.abs(a[i + k] - b[i + k]))) > 64) differ++;
  }
  return differ / (width * height);
}
