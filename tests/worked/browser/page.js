// What is looked at in a worked solution: asked for by check.py, each function gives a list of sentences.

const shown = e => e.getClientRects().length > 0;
const words = e => e.textContent.trim().replace(/\s+/g, ' ').slice(0, 60);

// What is wider than the page.
function overflow() {
  const page = document.documentElement, wide = page.scrollWidth - page.clientWidth;
  if (wide <= 0) return [];
  const out = [...document.querySelectorAll('main *')].filter(e => shown(e) && e.getBoundingClientRect().right > page.clientWidth + 0.5);
  return [`the page is ${wide} px wider than the window: ${out.slice(0, 3).map(e => `${e.tagName.toLowerCase()} "${words(e)}"`).join(', ')}`];
}

// Formulas of which a part is cut off: below, before, or behind a box that may not scroll.
function clipped(scrolls) {
  const found = [];
  for (const box of document.querySelectorAll('.eq, p, td, th')) {
    if (!shown(box)) continue;
    const style = getComputedStyle(box), r = box.getBoundingClientRect();
    if (style.overflowY === 'hidden' && box.scrollHeight > box.clientHeight + 1) {
      found.push(`"${words(box)}" is cut off by ${box.scrollHeight - box.clientHeight} px below`);
    }
    for (const math of box.querySelectorAll('math')) {
      const m = math.getBoundingClientRect();
      if (m.left < r.left - 1) found.push(`"${words(math)}" begins ${(r.left - m.left).toFixed(0)} px before its box`);
      if (!scrolls && m.right > r.right + 1) found.push(`"${words(math)}" is ${(m.right - r.right).toFixed(0)} px wider than its box`);
    }
  }
  return found;
}

// What scrolls by itself.
function bars() {
  const rolls = v => v === 'auto' || v === 'scroll';
  return [...document.querySelectorAll('main, main *')].filter(e => {
    const style = getComputedStyle(e);
    const [x, y] = [e.scrollWidth > e.clientWidth + 1, e.scrollHeight > e.clientHeight + 1];
    return shown(e) && (rolls(style.overflowX) && x || rolls(style.overflowY) && y);
  }).map(e => `${e.tagName.toLowerCase()} "${words(e)}" has a scroll bar`);
}

// Headings and tables, and contents that lead somewhere.
function outline() {
  const found = [], heads = [...document.querySelectorAll('h1,h2,h3,h4,h5,h6')], ids = [...document.querySelectorAll('[id]')].map(e => e.id);
  if (document.querySelectorAll('h1').length !== 1) found.push('there is not one heading of the first level');
  heads.forEach((h, i) => {
    if (+h.tagName[1] > (i ? +heads[i - 1].tagName[1] : 0) + 1) found.push(`the level of "${words(h)}" leaves out one`);
    if (!words(h)) found.push('a heading is empty');
  });
  for (const table of document.querySelectorAll('table')) {
    const heads = [...table.querySelectorAll('th')], [first] = table.rows;
    const name = `the table of "${words(first)}"`;
    if (!heads.length) found.push(`${name} has no header cells`);
    if (heads.some(h => !h.scope)) found.push(`${name} has header cells of nothing`);
    if (new Set([...table.rows].map(r => r.cells.length)).size > 1) found.push(`${name} has rows of different lengths`);
  }
  ids.filter((id, i) => ids.indexOf(id) !== i).forEach(id => found.push(`the id ${id} is there twice`));
  for (const a of document.querySelectorAll('a')) {
    const to = a.getAttribute('href');
    if (!to.startsWith('#') || !ids.includes(to.slice(1))) found.push(`${to} leads nowhere`);
  }
  return found;
}

// Text that stands out too little from its paper.
function contrast(least) {
  const light = colour => {
    const [r, g, b] = colour.match(/[\d.]+/g).map(x => x / 255).map(x => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const paper = light(getComputedStyle(document.body).backgroundColor), found = new Set();
  for (const e of document.querySelectorAll('main :is(h1,h2,h3,p,th,td,a,figcaption,math)')) {
    const ink = light(getComputedStyle(e).color), ratio = (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
    if (ratio < least) found.add(`${e.tagName.toLowerCase()} has a contrast of ${ratio.toFixed(1)}`);
  }
  return [...found];
}

// Lengths of the scale bars of all pictures in millimetres of paper, in order: what their paths say.
function lengths() {
  return [...document.querySelectorAll('svg.fig g.caption path')].map(p => p.getAttribute('d').match(/^M(\S+) \S+L(\S+) /).slice(1))
    .map(([a, b]) => b - a);
}

// How tall the tallest figure is that keeps its scale on paper, with its caption, mm.
function tallest() {
  const caption = 12, heights = [...document.querySelectorAll('figure:not(.free) svg.fig')].map(f => f.viewBox.baseVal.height);
  return Math.max(0, ...heights) + caption;
}

// Sentences that name a figure which is not there.
function figures() {
  const there = document.querySelectorAll('figure').length, found = [];
  for (const a of document.querySelectorAll('a[href^="#f"]')) {
    if (!document.querySelector(`figure${a.getAttribute('href')}`)) found.push(`${words(a)} is not one of ${there} figures`);
  }
  return found;
}
