// Moves the picture of a mechanism: the one player of the page of an animation, of the preview, of the panel in VS Code and of the
// playground. It places what the program computed and computes nothing of mechanics.

/**
 * How the parts of a picture move; every text of a series holds the whole numbers of all frames.
 * @typedef {object} Motion
 * @property {number} frames
 * @property {string} decimal the sign before decimals
 * @property {string[]} series of bodies: hundredths of a millimetre, of a degree
 * @property {number[][]} bodies centre, the series of right and down, that of the turn where it turns
 * @property {number[][]} followers a place that goes with a body and does not turn: x, y, body
 * @property {[string[], string][]} redrawn the texts of a part, and which one each frame shows
 * @property {string[]} faded whether a label is hidden
 * @property {[string, string, number, string][]} values name, unit, decimals, numbers in units of the last decimal
 * @property {string | null} along where the cursor of the plot is, hundredths of a millimetre
 * @property {Arrows[]} arrows
 * @property {string | null} shown the kind of arrows that is shown first
 */

/**
 * Arrows in one scale over all frames.
 * @typedef {object} Arrows
 * @property {string} kind
 * @property {string} scale in words
 * @property {[string, string, string, string, string][]} all name; the series of the tail and of the arrow, tenths of a millimetre
 */

/**
 * What a page has called.
 * @typedef {object} Hooks
 * @property {(part: number, playing: boolean) => void} [moved] another frame is shown: its part of the way
 * @property {(name: string, kind: string, event: MouseEvent) => void} [clicked] a part of the picture; the empty name where there is none
 * @property {(kind: string) => void} [show] a kind of arrows that the motion does not have
 */

const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
/** The way once at speed 1, ms; between two frames where less motion is wanted. */
const WAY = 6000, CALM = 1000;
const SPEEDS = [1, 4, 0.25];

/**
 * The numbers of a series: steps in digits of base 64, five bits each, the least first and the first bit the sign; ~ where there is none.
 * @param {string} text
 * @returns {(number | null)[]}
 */
function read(text) {
  const numbers = [];
  let value = 0, unit = 1, sum = 0;
  for (const letter of text) {
    const digit = DIGITS.indexOf(letter);
    if (digit < 0) {
      numbers.push(null);
      continue;
    }
    value += (digit % 32) * unit;
    unit *= 32;
    if (digit < 32) {
      sum += value % 2 ? (1 - value) / 2 : value / 2;
      numbers.push(sum);
      value = 0;
      unit = 1;
    }
  }
  return numbers;
}

/**
 * Plays a motion.
 * @param {HTMLElement} root holds the picture, the bar, the values and the plot, as the program wrote them
 * @param {Motion} motion
 * @param {Hooks} hooks
 * @param {HTMLElement | Document} keys where keys are listened to
 */
export function player(root, motion, hooks = {}, keys = root) {
  const { frames, decimal } = motion;
  const find = (/** @type {string} */ name) => root.querySelector(`.motion-${name}`);
  const [slider, output, cursor] = [/** @type {HTMLInputElement} */ (find("slider")), find("values"), find("cursor")];
  const [back, forth, pace, choice] = [find("back"), find("play"), find("speed"), /** @type {HTMLSelectElement | null} */ (find("show"))];
  const picture = /** @type {SVGSVGElement} */ (root.querySelector("svg"));
  const all = (/** @type {string} */ name) => [...picture.querySelectorAll(`.${name}`)];
  const few = matchMedia("(prefers-reduced-motion: reduce)");
  const series = motion.series.map(read);
  const bodies = motion.bodies.map(([x, y, right, down, turn], i) => ({ parts: all(`m${i}`), x, y, right: series[right], down: series[down], turn: series[turn] }));
  const followers = motion.followers.map(([x, y, body], i) => ({ parts: all(`f${i}`), x, y, by: bodies[body] }));
  const redrawn = motion.redrawn.map(([texts, which], i) => ({ parts: all(`r${i}`), texts, which: read(which) }));
  const faded = motion.faded.map((hidden, i) => ({ parts: all(`v${i}`), hidden: read(hidden) }));
  const values = motion.values.map(([name, unit, decimals, numbers]) => ({ name, unit, decimals, numbers: read(numbers) }));
  const along = motion.along === null ? [] : read(motion.along);
  /** @type {{ path: Element, tail: (number | null)[][], arrow: (number | null)[][] }[]} */
  let arrows = [];
  const ends = new AbortController();
  let frame = 0, sense = 0, speed = 0, before = 0;

  const move = (/** @type {Element[]} */ parts, /** @type {string} */ how) => parts.forEach((part) => part.setAttribute("transform", how));
  const said = (/** @type {number | null} */ number, /** @type {number} */ decimals) =>
    number === null ? "—" : (number / 10 ** decimals).toFixed(decimals).replace("-", "−").replace(".", decimal);

  /** @param {number} i */
  function show(i) {
    frame = Math.min(Math.max(i, 0), frames - 1);
    for (const { parts, x, y, right, down, turn } of bodies) {
      const turned = turn ? ` rotate(${(turn[frame] ?? 0) / 100})` : "";
      move(parts, `translate(${(right[frame] ?? 0) / 100 + x} ${(down[frame] ?? 0) / 100 + y})${turned} translate(${-x} ${-y})`);
    }
    for (const { parts, x, y, by } of followers) {
      const angle = by.turn ? ((by.turn[frame] ?? 0) * Math.PI) / 18000 : 0, [u, v] = [x - by.x, y - by.y];
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      move(parts, `translate(${(by.right[frame] ?? 0) / 100 + u * cos - v * sin - u} ${(by.down[frame] ?? 0) / 100 + u * sin + v * cos - v})`);
    }
    for (const { parts, texts, which } of redrawn) for (const part of parts) part.innerHTML = texts[which[frame] ?? 0];
    for (const { parts, hidden } of faded) for (const part of parts) /** @type {SVGElement} */ (part).style.opacity = hidden[frame] ? "0" : "1";
    for (const { path, tail, arrow } of arrows) path.setAttribute("d", drawn(tail.map((at) => at[frame]), arrow.map((d) => d[frame])));
    if (output) output.textContent = values.map(({ name, unit, decimals, numbers }) => `${name} = ${said(numbers[frame], decimals)}${numbers[frame] === null ? "" : unit}`).join("   ");
    slider.value = String(frame);
    if (cursor) {
      const at = along[frame] ?? null;
      cursor.setAttribute("visibility", at !== null && at >= -1 && at <= 15001 ? "visible" : "hidden");
      cursor.setAttribute("transform", `translate(${(at ?? 0) / 100} 0)`);
    }
    hooks.moved?.(part(), sense !== 0);
  }

  const part = () => (frames > 1 ? frame / (frames - 1) : 0);

  /** @param {number} now */
  function step(now) {
    if (sense === 0) return;
    const pause = few.matches ? CALM : WAY / frames / SPEEDS[speed];
    if (now - before >= pause) {
      const most = few.matches ? Math.ceil(frames / 12) : Math.max(1, Math.ceil((frames / 45) * SPEEDS[speed]));
      const count = few.matches ? most : Math.max(1, Math.min(most, Math.floor((now - before) / pause)));
      before = now;
      show((frame + sense * count + 2 * frames) % frames);
    }
    requestAnimationFrame(step);
  }

  /** @param {boolean} on @param {number} way */
  function play(on, way = 1) {
    const starts = on && sense === 0;
    sense = on ? way : 0;
    if (forth) forth.textContent = sense > 0 ? "❚❚" : "▶";
    if (back) back.textContent = sense < 0 ? "❚❚" : "◀";
    if (starts) requestAnimationFrame(step);
    else if (!on) hooks.moved?.(part(), false);
  }

  /** @param {number} by */
  function go(by) {
    play(false);
    show((frame + by + frames) % frames);
  }

  /** Shows the arrows of a kind in place of those before. @param {string} kind */
  function point(kind) {
    picture.querySelector(":scope > .motion-arrows")?.remove();
    arrows = [];
    const found = motion.arrows.find((one) => one.kind === kind);
    const scale = find("scale");
    if (scale) scale.textContent = found?.scale ?? "";
    if (choice) choice.value = kind;
    if (found) {
      const make = (/** @type {string} */ name) => document.createElementNS("http://www.w3.org/2000/svg", name);
      const group = picture.appendChild(make("g"));
      group.setAttribute("class", `motion-arrows ${kind}`);
      arrows = found.all.map(([name, ...numbers]) => {
        const path = group.appendChild(make("path"));
        path.appendChild(make("title")).textContent = name;
        const [x, y, dx, dy] = numbers.map(read);
        return { path, tail: [x, y], arrow: [dx, dy] };
      });
    }
    show(frame);
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    const at = /** @type {HTMLElement} */ (event.target);
    if (event.altKey || event.ctrlKey || event.metaKey || at.isContentEditable || ["BUTTON", "SELECT", "TEXTAREA", "SUMMARY"].includes(at.tagName)) return;
    if (event.key === " ") play(sense === 0);
    else if (event.key === "[" || (at !== slider && event.key === "ArrowLeft")) go(-1);
    else if (event.key === "]" || (at !== slider && event.key === "ArrowRight")) go(1);
    else return;
    event.preventDefault();
  }

  /** @param {{ class: string, name: string } | null} what */
  function mark(what) {
    for (const group of picture.querySelectorAll("[data-name]")) {
      const is = what !== null && group.getAttribute("data-name") === what.name && group.classList[0] === what.class;
      group.classList.toggle("motion-marked", is);
    }
  }

  const listens = { signal: ends.signal };
  const on = (/** @type {Element | null} */ at, /** @type {string} */ name, /** @type {(event: any) => void} */ does) => at?.addEventListener(name, does, listens);
  on(slider, "input", () => (play(false), show(Number(slider.value))));
  on(forth, "click", () => play(sense <= 0, 1));
  on(back, "click", () => play(sense >= 0, -1));
  on(pace, "click", () => {
    speed = (speed + 1) % SPEEDS.length;
    if (pace) pace.textContent = ["1×", "4×", "¼×"][speed];
  });
  on(choice, "change", () => {
    const kind = choice?.value ?? "";
    if (kind === "" || motion.arrows.some((one) => one.kind === kind)) point(kind);
    else hooks.show?.(kind);
  });
  on(picture, "click", (event) => {
    const group = event.target.closest("[data-name]");
    hooks.clicked?.(group?.dataset.name ?? "", group?.classList[0] ?? "", event);
  });
  keys.addEventListener("keydown", /** @type {EventListener} */ (key), listens);
  point(motion.shown ?? "");
  return {
    frames,
    get part() { return part(); },
    get playing() { return sense !== 0; },
    get shown() { return choice?.value ?? ""; },
    show,
    /** Goes to a part of the way, from 0 to 1. @param {number} where */
    at: (where) => show(Math.round(where * (frames - 1))),
    play,
    mark,
    /** Listens no more and stands still. */
    end() {
      sense = 0;
      ends.abort();
    },
  };
}

/**
 * An arrow as the text of a path: its line and its head; nothing where it has no length.
 * @param {(number | null)[]} tail @param {(number | null)[]} arrow tenths of a millimetre
 */
function drawn([x, y], [dx, dy]) {
  if (x === null || y === null || dx === null || dy === null) return "";
  const length = Math.hypot(dx, dy);
  if (length < 3) return "";
  const [u, v] = [dx / length, dy / length], head = Math.min(24, 0.6 * length), half = 0.3 * head;
  const at = (/** @type {number} */ along, /** @type {number} */ across) => `${((x + along * u - across * v) / 10).toFixed(2)} ${((y + along * v + across * u) / 10).toFixed(2)}`;
  return `M${at(0, 0)}L${at(length - head, 0)}M${at(length, 0)}L${at(length - head, half)}L${at(length - head, -half)}Z`;
}
