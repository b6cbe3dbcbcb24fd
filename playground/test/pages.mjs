// The page in Debian's Chromium, as a reader uses it.

import assert from "node:assert/strict";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { chromium } from "playwright-core";
import { serve } from "../serve.mjs";
import { broken, encode } from "./links.mjs";

const DIST = new URL("../dist/", import.meta.url);
const PROGRAM = process.env.CHROMIUM ?? "/usr/bin/chromium";
/** What a page may take on a busy machine, ms. */
const PATIENCE = 30_000;
const SLIDER = readFileSync(new URL("../../examples/crank-slider.mech", import.meta.url), "utf8");

let browser, site;
const foreign = [];

/** A page at an address of the playground; what it says and asks for is held. */
async function open(hash = "", { size = [1280, 800], text, worker, slow, ...more } = {}) {
  site ??= await serve();
  browser ??= await chromium.launch({ executablePath: PROGRAM, args: ["--no-sandbox"] });
  const context = await browser.newContext({ viewport: { width: size[0], height: size[1] }, hasTouch: size[0] < 700, locale: "en", acceptDownloads: true, ...more });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  page.faults = [];
  page.on("pageerror", (error) => page.faults.push(error.stack));
  page.on("console", (message) => message.type() === "error" && page.faults.push(message.text()));
  page.on("request", (request) => /^(https?|wss?):/.test(request.url()) && !request.url().startsWith(site.address) && foreign.push(request.url()));
  if (worker !== undefined) {
    const body = worker + readFileSync(new URL("worker.js", DIST), "utf8");
    await page.route("**/worker.js", (route) => route.fulfill({ contentType: "text/javascript", body }));
  }
  if (slow !== undefined) await page.route("**/assur.wasm.gz", async (route) => (await new Promise((then) => setTimeout(then, slow)), route.continue()));
  if (text !== undefined) await page.addInitScript((own) => localStorage.getItem("assur-text") === null && localStorage.setItem("assur-text", own), text);
  await page.goto(/^(file|about):/.test(hash) ? hash : site.address + hash);
  return page;
}

const ready = (page, count = 1) => page.waitForFunction((least) => Number(document.body.dataset.ready) >= least, count);
const count = (page) => page.evaluate(() => Number(document.body.dataset.ready ?? 0));
const state = (page, text) => page.waitForFunction((wanted) => document.getElementById("state").textContent === wanted, text);
const typed = (page) => page.evaluate(() => document.querySelector(".cm-content").cmTile?.view?.state.doc.toString() ?? document.querySelector(".cm-content").innerText);

/** Another text, as if it were pasted. */
async function paste(page, text) {
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+a");
  await page.evaluate((content) => {
    const data = new DataTransfer();
    data.setData("text/plain", content);
    document.querySelector(".cm-content").dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, text);
}

async function closed(page) {
  assert.deepEqual(page.faults, []);
  await page.context().close();
}

/** A worker whose module never comes back from a text with this word. */
const ENDLESS = `const Real = WebAssembly.Instance;
let hangs = false;
WebAssembly.Instance = function (module, imports) {
  const { memory, reserve, free, handle } = new Real(module, imports).exports;
  return { exports: { memory, reserve, free, handle(at, length) {
    const message = new TextDecoder().decode(new Uint8Array(memory.buffer, at, length));
    if (/"method":"textDocument.did(Change|Open)"/.test(message)) hangs = message.includes("ENDLESS");
    while (hangs && message.includes('"assur/solve"'));
    return handle(at, length);
  } } };
};
`;

const WRONG = [
  ["link crank A-B", "lnk crank A-B"],
  ["revolute  B: crank - rod", "revolute  B: crank - rodd"],
  ["revolute  A: ground", "revolut  A: ground"],
  ["drive crank", "drive cranck"],
  ["balance torque M on crank", "balance torque M on krank"],
  ["assemble C ahead of B", "assemble C ahead off B"],
  ["find M, velocity(C)", "find M, velocty(C)"],
  ["100 mm", "100 mmm"],
  ["prismatic D: slider.C", "prismatc D: slider.C"],
  ["at 120 rpm", "at 120 rmp"],
];
const STEPS = `mech 1
mechanism "My crank-slider"
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B 100 mm
link rod B-C 350 mm
link slider { C (0, 0) }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - slider
prismatic D: slider.C - ground.guide
drive crank = 0 deg .. 360 deg in 36 steps at 120 rpm
assemble C ahead of B
force F on slider at C = 500 N @ 180 deg
balance torque M on crank
find M, velocity(C)
`;

/** Markup in every place that a text has, and in links. */
function attacks() {
  const marks = ["<img src=x onerror=hit()>", "<script>hit()</script>", "</script><script>hit()</script>", "<svg onload=hit()>", "<a href=javascript:hit()>a</a>", "<iframe srcdoc='<script>parent.hit()</script>'>", "\"><b onmouseover=hit()>", "<style>*{display:none}</style>", "![a](javascript:hit())", "</textarea><img src=x onerror=hit()>"];
  const places = [
    (mark) => STEPS.replace("My crank-slider", mark.replaceAll('"', "'")),
    (mark) => `// ${mark}\n${STEPS}`,
    (mark) => STEPS.replaceAll("crank", mark),
    (mark) => STEPS.replace('mechanism "My crank-slider"\n', `mechanism "x"\n// ${mark}\n`),
    (mark) => `${STEPS}expect M = ${mark}\n`,
  ];
  return marks.flatMap((mark) => places.map((place) => place(mark)));
}

/** Windows of the usual screens: laptop, desktop, tablet, phone; the phone while its text is written, without a plot. */
const WINDOWS = [[1366, 768], [1920, 1080], [820, 1180], [390, 844], [390, 844, "text"]];

/** What of picture, plot, bar and values is out of sight in a window, or too small, with the page alone or in another page. */
async function hidden(page) {
  const found = [];
  for (const [width, height, tab = "answers"] of WINDOWS) {
    await page.setViewportSize({ width, height });
    for (const embed of tab === "text" ? [false] : [false, true]) {
      const wrong = await page.evaluate(async ([tab, embed]) => {
        const stage = document.getElementById("stage");
        document.getElementById(`tab-${tab}`).click();
        document.body.classList.toggle("embed", embed);
        document.getElementById("text").open = !embed;
        stage.scrollIntoView();
        await new Promise((then) => requestAnimationFrame(() => requestAnimationFrame(then)));
        const seen = stage.getBoundingClientRect(), wrong = [];
        const low = Math.min(seen.bottom, innerHeight), right = Math.min(seen.right, innerWidth);
        if (stage.scrollHeight > stage.clientHeight || stage.scrollWidth > stage.clientWidth) wrong.push("the pane scrolls");
        for (const part of stage.querySelectorAll("svg, .motion-bar > *, .motion-values")) {
          const box = part.getBoundingClientRect();
          const out = box.top < seen.top - 1 || box.bottom > low + 1 || box.left < seen.left - 1 || box.right > right + 1;
          if (out && box.width > 0) wrong.push(`${part.getAttribute("class") ?? part.tagName} is cut`);
        }
        const picture = stage.querySelector("svg"), box = picture.getBoundingClientRect(), { width, height } = picture.viewBox.baseVal;
        const drawn = Math.min(box.width / width, box.height / height) * Math.max(width, height);
        if (drawn < 200) wrong.push(`the picture is ${drawn.toFixed()} px`);
        document.body.classList.remove("embed");
        return wrong;
      }, [tab, embed]);
      found.push(...wrong.map((one) => `${width} x ${height}${embed ? " embedded" : ""} ${tab}: ${one}`));
    }
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.locator("#tab-answers").click();
  return found;
}

export const pages = {
  async "page: the mechanism moves, with its answers and its plot"() {
    const page = await open("#x/crank-slider");
    await ready(page);
    assert.match(await page.locator("#pane-answers").innerText(), /Mb\s+472\.064/);
    const crank = page.locator('#picture g.link[data-name="crank"] .l').first();
    const before = await crank.boundingBox();
    await page.locator(".motion-play").click();
    await page.waitForTimeout(400);
    assert.notDeepEqual(await crank.boundingBox(), before);
    await page.locator(".motion-play").click();
    // arrows that the text does not call for
    await page.locator(".motion-show").selectOption("velocities");
    await page.locator(".motion-arrows.velocities path").first().waitFor({ state: "attached" });
    assert.match(await page.locator(".motion-scale").innerText(), /m\/s/);
    // a part of the picture leads to its statement
    await page.locator('#picture g.link[data-name="rod"] .l').first().click({ force: true });
    assert.match(await page.locator(".cm-activeLine").innerText(), /^link 2 rod/);
    await closed(page);
  },

  async "page: a slip is a sentence, grey, and mended by its fix"() {
    const page = await open("", { text: STEPS });
    await ready(page);
    await paste(page, STEPS.replace("rod - slider", "rodd - slider"));
    await page.locator("#strip .sentence").waitFor();
    assert.match(await page.locator("#strip").innerText(), /rodd.*line 9/s);
    assert.ok(await page.evaluate(() => document.body.classList.contains("old")));
    await page.locator(".cm-lintRange-error").first().waitFor();
    await page.keyboard.press("Control+.");
    await page.locator("#pane-problems .fix").first().click();
    await state(page, "ok");
    await page.waitForFunction(() => !document.body.classList.contains("old"));
    assert.match(await typed(page), /revolute {2}C: rod - slider/);
    await closed(page);
  },

  async "page: a number that changes changes the answers, and the pose stays"() {
    const page = await open("", { text: STEPS });
    await ready(page);
    await page.evaluate(() => {
      const slider = document.querySelector(".motion-slider");
      slider.value = String(Math.round(slider.max / 4));
      slider.dispatchEvent(new Event("input"));
    });
    const [part, before] = [await page.locator(".motion-slider").inputValue(), await page.locator("#pane-answers").innerText()];
    const seen = await count(page);
    await paste(page, STEPS.replace("350 mm", "300 mm"));
    await ready(page, seen + 1);
    assert.notEqual(await page.locator("#pane-answers").innerText(), before);
    assert.equal(await page.locator(".motion-slider").inputValue(), part);
    await closed(page);
  },

  async "page: nothing sticks: too many steps, an endless run, ten megabytes, no module"() {
    const page = await open("", { text: STEPS, worker: ENDLESS });
    await ready(page);
    // the sentence about the text before stays until the new one is read
    const late = async (text, sentence) => {
      const begin = Date.now();
      await paste(page, text);
      await page.waitForFunction((wanted) => new RegExp(wanted).test(document.getElementById("strip").textContent), sentence, { timeout: 12_000 });
      const answered = Date.now();
      await paste(page, STEPS.replace("rod - slider", "rodd - slider"));
      await page.locator(".cm-lintRange-error").first().waitFor();
      return [answered - begin, Date.now() - answered];
    };
    const many = await late(STEPS.replace("36 steps", "1000000 steps"), "longer than 5 s|positions");
    const endless = await late(`// ENDLESS\n${STEPS}`, "longer than 5 s");
    const huge = await late("// a line that is long enough to fill a text\n".repeat(230_000), "the file is empty");
    await closed(page);
    const without = await open("#x/first");
    await without.route("**/assur.wasm.gz", (route) => route.abort());
    await without.reload();
    await without.waitForFunction(() => document.getElementById("strip").textContent.includes("cannot be loaded"));
    await without.context().close();
    return `sentences after ${many[0]}, ${endless[0]}, ${huge[0]} ms; the next key after ${many[1]}, ${endless[1]}, ${huge[1]} ms`;
  },

  async "page: of long tables the first rows are drawn, more when they are wanted, and keys are answered"() {
    const page = await open("", { text: STEPS.replace("36 steps", "2000 steps").replace("find M", "find reactions, M") });
    await ready(page);
    const tables = page.locator("#pane-answers .table"), foot = page.locator("#pane-answers .rows").first();
    const rows = () => tables.evaluateAll((all) => all.map((one) => one.querySelectorAll("tbody tr").length));
    const first = await rows();
    assert.ok(first.length > 3 && Math.max(...first) === 200, `rows ${first}`);
    assert.match(await foot.innerText(), /200 of 2000 rows\s+Show 1000 more/);
    for (const [wanted, says] of [[1200, /1200 of 2000 rows\s+Show 800 more/], [2000, /^2000 of 2000 rows$/]]) {
      await foot.locator("button").click();
      await page.waitForFunction((most) => document.querySelector("#pane-answers .rows").closest(".table").querySelectorAll("tbody tr").length === most, wanted);
      assert.match((await foot.innerText()).trim(), says);
    }
    assert.ok((await rows()).filter((one) => one === 200).length === first.filter((one) => one === 200).length - 1, "the other tables are as they were");
    // the longest time without a frame, from a key to its answers: the least of some, as a machine is busy with other things, too
    const gaps = [];
    for (let i = 0; i < 4 && !(Math.min(...gaps) < 300); i += 1) {
      const seen = await count(page);
      await page.locator(".cm-content").click();
      await page.evaluate(() => {
        window.gap = 0;
        let last = performance.now();
        const frame = (now) => ((window.gap = Math.max(window.gap, now - last)), (last = now), requestAnimationFrame(frame));
        requestAnimationFrame(frame);
      });
      await page.keyboard.type(" ");
      await ready(page, seen + 1);
      await page.waitForTimeout(300);
      gaps.push(await page.evaluate(() => Math.round(window.gap)));
    }
    assert.ok(Math.min(...gaps) < 300, `without a frame for ${gaps} ms`);
    await closed(page);
    return `without a frame for ${gaps} ms at most`;
  },

  async "page: markup is shown and never run: 50 tries"() {
    const page = await open("", { text: STEPS });
    await page.evaluate(() => (window.hit = () => (window.hits = (window.hits ?? 0) + 1)));
    await ready(page);
    const all = attacks();
    assert.equal(all.length, 50);
    for (const text of all) {
      await paste(page, text);
      await page.waitForTimeout(120);
    }
    for (const tab of ["answers", "worked", "pictures", "problems"]) {
      await page.locator(`#tab-${tab}`).click();
      await page.waitForTimeout(150);
    }
    await page.locator(".cm-line").nth(1).hover();
    await page.waitForTimeout(600);
    assert.equal(await page.evaluate(() => window.hits), undefined);
    assert.equal(await page.locator("img[src=x], [onerror], [onload], [onmouseover]").count(), 0);
    await closed(page);
  },

  async "page: 20 broken links give a sentence and a page that works"() {
    for (const [hash, kind] of (await broken()).filter((_, i) => i % 2 === 0)) {
      const page = await open(hash);
      await page.waitForFunction(() => document.getElementById("notice").textContent !== "");
      const said = await page.locator("#notice").innerText();
      assert.match(said, kind === "newer" ? /newer/ : kind === "example" ? /no example/ : /not complete/);
      await paste(page, STEPS);
      await ready(page);
      await closed(page);
    }
  },

  async "page: what is written before the module has come stays"() {
    const page = await open("#hello", { slow: 1500 });
    await page.waitForFunction(() => document.getElementById("notice").textContent !== "");
    assert.equal(await page.evaluate(() => document.body.dataset.ready), undefined);
    await paste(page, STEPS);
    await ready(page);
    assert.equal(await typed(page), STEPS);
    await closed(page);
  },

  async "page: what the author wrote is kept when an example, a link or the tutorial takes its place"() {
    const page = await open("", { text: STEPS });
    await ready(page);
    const mine = STEPS.replace("My crank-slider", "Mine"), link = await encode(STEPS.replace("My crank-slider", "Of a friend"), "0.1.0");
    const example = async (name) => {
      await page.keyboard.press("Control+k");
      await page.locator("#gallery small").getByText(name, { exact: true }).click();
    };
    const shows = (text) => page.waitForFunction((part) => document.querySelector(".cm-content").innerText.includes(part), text);
    await paste(page, mine);
    // at once, before anything is kept
    await example("crank-slider");
    await example("first");
    assert.ok(await page.locator("#mine").isVisible());
    await page.reload();
    await ready(page);
    await page.locator("#mine").click();
    assert.equal(await typed(page), mine);
    assert.ok(!page.url().includes("#"), "the address of the example is gone");
    await page.reload();
    await ready(page);
    assert.equal(await typed(page), mine);
    // an example that was changed takes no place of the older text, and is a text of the author's
    await example("crank-slider");
    await paste(page, STEPS.replace("My crank-slider", "Changed"));
    await page.evaluate((hash) => (location.hash = hash), link);
    await shows("Of a friend");
    await page.keyboard.press("Control+k");
    assert.deepEqual(await page.locator("#gallery section", { hasText: "My texts" }).locator("b").allInnerTexts(), ["Changed", "Mine"]);
    await page.locator("#gallery b").getByText("Mine", { exact: true }).click();
    assert.equal(await typed(page), mine);
    // the tutorial, and an example from there
    await page.locator("#tutorial").click();
    await paste(page, "mech 1\n");
    await page.locator("#pane-tutorial button").last().click();
    assert.equal(await typed(page), mine);
    await page.locator("#tutorial").click();
    await example("crank-slider");
    await page.locator("#mine").click();
    assert.equal(await typed(page), mine);
    // a link that cannot be read hides nothing either
    await page.goto(`${site.address}?#hello`);
    await page.locator("#mine").click();
    assert.equal(await typed(page), mine);
    await closed(page);
  },

  async "page: without storage the author's text is there until the page ends"() {
    const page = await open("about:blank");
    await page.addInitScript(() => Object.defineProperty(window, "localStorage", { get: () => { throw new Error("refused"); } }));
    await page.goto(site.address);
    await ready(page);
    await paste(page, STEPS);
    await page.evaluate(() => (location.hash = "#x/crank-slider"));
    await page.locator("#mine").click();
    assert.equal(await typed(page), STEPS);
    await closed(page);
  },

  async "page: the gallery shows 24 and finds the others"() {
    const page = await open("", { text: STEPS });
    await ready(page);
    await page.keyboard.press("Control+k");
    await page.locator("#gallery .card").nth(23).waitFor();
    assert.equal(await page.locator("#gallery .card").count(), 24);
    await page.locator("#gallery input").fill("geneva");
    await page.waitForFunction(() => document.querySelectorAll("#gallery .card").length < 20);
    const seen = await count(page);
    await page.locator("#gallery .card").first().click();
    await ready(page, seen + 1);
    assert.match(page.url(), /#x\/.*geneva/);
    // what was there before is not lost
    await page.locator("#mine").click();
    assert.equal(await typed(page), STEPS);
    await closed(page);
  },

  async "page: all 24 examples of the gallery move or show their figures, whole in every window"() {
    const all = JSON.parse(readFileSync(new URL("examples.json", DIST), "utf8")).filter((one) => one.chapter);
    const page = await open("", { text: STEPS });
    await ready(page);
    for (const { name, text } of all) {
      const seen = await count(page);
      await paste(page, text);
      await ready(page, seen + 1);
      assert.ok((await page.locator("#picture svg").count()) > 0, name);
      assert.ok((await page.locator("#pane-answers").innerText()).length > 20, name);
      assert.deepEqual(await hidden(page), [], name);
    }
    await closed(page);
    return `${all.length} examples`;
  },

  async "page: the picture keeps its size while its values change"() {
    const page = await open("#x/contacts/geneva-turns", { size: [390, 844] });
    await ready(page);
    const sizes = await page.evaluate(async () => {
      const slider = document.querySelector(".motion-slider"), svg = document.querySelector("#picture svg"), sizes = [new Set(), new Set()];
      for (const size of sizes) {
        for (let frame = 0; frame <= slider.max; frame += 1) {
          slider.value = String(frame);
          slider.dispatchEvent(new Event("input"));
          await new Promise((then) => requestAnimationFrame(then));
          size.add(svg.clientHeight);
        }
      }
      return sizes.map((size) => [...size]);
    });
    // a line more is taken once and not given back
    assert.equal(sizes[1].length, 1, `heights ${sizes[1]}`);
    assert.ok(sizes[0].length <= 3, `heights ${sizes[0]}`);
    await closed(page);
  },

  async "page: a link is shared, opened and embedded"() {
    const page = await open("", { text: STEPS });
    await ready(page);
    await page.locator("#share").click();
    const link = await page.locator("#dialog input").first().inputValue();
    assert.match(await page.locator("#dialog").innerText(), /fits everywhere/);
    const frame = await page.locator("#dialog input").nth(2).inputValue();
    await closed(page);
    const other = await open(link.slice(site.address.length));
    await ready(other);
    assert.equal(await typed(other), STEPS);
    await closed(other);
    const embedded = await open(/src="([^"]*)"/.exec(frame)[1].slice(site.address.length));
    await ready(embedded);
    assert.ok(!(await embedded.locator("header").isVisible()) && (await embedded.locator("#picture svg").first().isVisible()));
    assert.ok(!(await embedded.locator(".cm-content").isVisible()));
    await embedded.locator("summary").first().click();
    assert.ok(await embedded.locator(".cm-content").isVisible());
    await closed(embedded);
  },

  async "page: <assur-mech> moves in another page, and is text without a script"() {
    const name = "test-element.html";
    writeFileSync(new URL(name, DIST), `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,"><script type="module" src="embed/assur-mech.js"></script><assur-mech>\n${STEPS.replaceAll("<", "&lt;")}</assur-mech>`);
    try {
      const page = await open(name);
      const frame = page.frameLocator("assur-mech iframe");
      await frame.locator("#picture svg").first().waitFor();
      await page.waitForFunction(() => parseInt(document.querySelector("iframe").style.height) !== 352);
      for (const [width, height] of WINDOWS) {
        await page.setViewportSize({ width, height });
        await page.waitForFunction(() => document.querySelector("iframe").clientHeight <= innerHeight);
        const [outer, picture] = [await page.locator("iframe").boundingBox(), await frame.locator("#picture").boundingBox()];
        assert.ok(picture.height > 200 && picture.y + picture.height <= outer.y + outer.height, `${width} x ${height}`);
      }
      await closed(page);
      const plain = await open(name, { javaScriptEnabled: false });
      assert.match(await plain.locator("assur-mech").innerText(), /link crank A-B 100 mm/);
      await plain.context().close();
    } finally {
      rmSync(new URL(name, DIST));
    }
  },

  async "page: one file works from a disk without a request"() {
    const page = await open(new URL("playground.html", DIST).href);
    const asked = [];
    page.on("request", (request) => /^(https?|file):/.test(request.url()) && asked.push(request.url()));
    await ready(page);
    assert.deepEqual(asked, []);
    await page.keyboard.press("Control+k");
    await page.locator("#gallery .card").nth(23).waitFor();
    await closed(page);
  },

  async "page: every file is saved"() {
    const page = await open("", { text: STEPS });
    await ready(page);
    await page.keyboard.press("Control+s");
    const buttons = page.locator("#dialog .wide"), said = [];
    for (let i = 0; i < (await buttons.count()); i += 1) {
      const [file] = await Promise.all([page.waitForEvent("download"), buttons.nth(i).click()]);
      const bytes = readFileSync(await file.path()), name = file.suggestedFilename();
      said.push(name);
      const begins = { mech: "mech 1", svg: "<svg ", csv: "pose", json: '{"schema"', html: "<!doctype html>" }[name.split(".").at(-1)];
      if (begins) assert.ok(bytes.toString("utf8").startsWith(begins), `${name}: ${bytes.subarray(0, 40)}`);
      else assert.deepEqual([...bytes.subarray(1, 4)], [0x50, 0x4e, 0x47], name);
    }
    assert.equal(said.length, 9);
    await closed(page);
    return said.join(", ");
  },

  async "page: the worked solution, the pictures and the other languages"() {
    const page = await open("", { text: STEPS });
    await ready(page);
    await page.keyboard.press("Alt+2");
    await page.frameLocator("#pane-worked iframe").locator("math").first().waitFor();
    await page.keyboard.press("Alt+3");
    await page.locator("#pane-pictures figure svg").nth(1).waitFor();
    for (const [language, word, worked] of [["ru", "Ответы", "Скорости"], ["zh", "答案", "速度"]]) {
      await page.locator("#language").selectOption(language);
      assert.match(await page.locator("#tabs").innerText(), new RegExp(word));
      await page.keyboard.press("Alt+2");
      await page.frameLocator("#pane-worked iframe").locator("h2", { hasText: worked }).first().waitFor();
    }
    await closed(page);
  },

  async "page: the tutorial is done by keyboard alone"() {
    for (const language of ["en", "ru", "zh"]) {
      const page = await open("");
      await ready(page);
      await page.evaluate((one) => {
        const choice = document.getElementById("language");
        choice.value = one;
        choice.dispatchEvent(new Event("change"));
      }, language);
      await page.keyboard.press("Alt+5");
      for (let step = 0; step < 6; step += 1) {
        const now = page.locator("#pane-tutorial li.now pre");
        await page.waitForFunction((at) => document.querySelectorAll("#pane-tutorial li.done").length === at && document.querySelector("#pane-tutorial li.now pre"), step);
        for (const line of (await now.innerText()).split("\n")) {
          await page.keyboard.press("Control+End");
          // brackets close themselves, and offers do not take the end of a line
          await page.keyboard.insertText(line);
          await page.keyboard.press("Escape");
          await page.keyboard.press("Enter");
        }
      }
      await page.waitForFunction(() => document.querySelectorAll("#pane-tutorial li.done").length === 6);
      await page.keyboard.press("Alt+1");
      // texts on the way may have been solved, too
      await page.waitForFunction(() => /M/.test(document.getElementById("pane-answers").innerText));
      await closed(page);
    }
  },

  async "page: by keyboard alone: editor, tabs, dialogs"() {
    const page = await open("", { text: STEPS });
    await ready(page);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Escape");
    await page.keyboard.press("Tab");
    assert.ok(!(await page.evaluate(() => document.activeElement.isContentEditable)), "the editor is left");
    await page.locator("#tab-answers").focus();
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.evaluate(() => document.activeElement.id), "tab-worked");
    await page.keyboard.press("?");
    await page.locator("#dialog kbd").first().waitFor();
    await page.keyboard.press("Escape");
    await page.locator("#picture").focus();
    const before = await page.locator(".motion-slider").inputValue();
    await page.keyboard.press("]");
    assert.equal(Number(await page.locator(".motion-slider").inputValue()), Number(before) + 1);
    await closed(page);
  },

  async "page: on a phone ten wrong files are mended by what the page offers"() {
    const page = await open("", { size: [360, 740], text: STEPS });
    await ready(page);
    await page.locator("#tab-text").tap();
    for (const [right, slip] of WRONG) {
      assert.ok(STEPS.includes(right), right);
      await paste(page, STEPS.replace(right, slip));
      await page.waitForFunction(() => document.querySelector("#first .fix"), null, { timeout: 10_000 }).catch(() => assert.fail(`no fix for ${slip}`));
      const box = await page.locator("#first .fix").first().boundingBox();
      assert.ok(box.height >= 44, `a button of ${box.height} px`);
      await page.locator("#first .fix").first().tap();
      await state(page, "ok").catch(() => assert.fail(`${slip} is not mended`));
    }
    await closed(page);
  },

  async "page: nothing is wider than its window"() {
    for (const width of [360, 820, 1280]) {
      for (const name of ["crank-slider", "kinetostatics/six-bar", "simulation/trebuchet", "cams/lever", "trains/planetary-gearbox"]) {
        const page = await open(`#x/${name}`, { size: [width, 800] });
        await ready(page);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `${name} at ${width} px: ${wide} px`);
        await closed(page);
      }
    }
  },

  async "page: no request left the origin"() {
    await browser?.close();
    site?.server.close();
    assert.deepEqual(foreign, []);
  },
};
