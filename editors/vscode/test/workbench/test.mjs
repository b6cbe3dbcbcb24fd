// The packaged extension in VS Code's own workbench, in Chromium, with the program and with the built-in server: colours, a mistake, hover,
// its fix by keyboard, formatting, the preview, and which server is taken. ASSUR names the program, PICTURES a folder for the pictures of
// the documents.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

const main = createRequire(import.meta.url).resolve("code-server/lib/vscode/out/server-main.js");
const vsix = new URL("../../mech.vsix", import.meta.url).pathname;

const root = new URL("../../../..", import.meta.url).pathname;
// files with one mistake and one fix each
const fixes = readFileSync(join(root, "editors", "fixes.txt"), "utf8").trim().split("\n");
const fileOf = (name) => `${name.replaceAll("/", "-")}.mech`;

const home = mkdtempSync(join(tmpdir(), "assur-workbench-"));
const places = ["--server-data-dir", home, "--user-data-dir", join(home, "data"), "--extensions-dir", join(home, "extensions")];
const settings = {
  "security.workspace.trust.enabled": false,
  "workbench.startupEditor": "none",
  "workbench.colorTheme": "Default Light Modern",
  "workbench.tips.enabled": false,
  "editor.minimap.enabled": false,
  "editor.hover.delay": 100,
  "files.autoSave": "off",
};
const text = `mech 1
mechanism "A crank-slider engine"
// Find the torque on the crank.
given   n = 1500 rpm
ground { A (0, 0); line guide through A along 0 deg }
link crank  A-B 100 mm
link rod    B-C 350 mm
link piston { C (0, 0); mass 2.14 kg at C }

revolute  A: ground - crank
revolute  B: crank - rodd
revolute  C: rod - piston
prismatic D: piston.C - ground.guide

drive crank = 45 deg at n
assemble C ahead of B
balance torque Mb on crank
find Mb, v = velocity(C).x as m/s
`;

/** Whether a frame shows a page that the program serves. */
const isServed = (frame) => /^http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\//.test(frame.url());

const servers = {
  program: {
    name: "program",
    folder: join(home, "homework"),
    status: /^assur \d+\.\d+\.\d+$/,
    isPicture: isServed,
  },
  builtIn: {
    name: "built-in",
    folder: join(home, "exercises"),
    status: /^assur \d+\.\d+\.\d+ \(built in\)$/,
    isPicture: (frame) => !isServed(frame),
  },
};

function prepare() {
  execFileSync(process.execPath, [main, ...places, "--install-extension", vsix], { stdio: "ignore" });
  choose(resolve(process.env.ASSUR));
  writeFileSync(join(home, "assur"), "#!/bin/sh\necho assur 9.1.0\n", { mode: 0o755 });
  for (const { folder } of Object.values(servers)) {
    mkdirSync(folder);
    writeFileSync(join(folder, "engine.mech"), text);
    writeFileSync(join(folder, "new.mech"), "");
    writeFileSync(join(folder, "notes.md"), "# Notes\n\n```mech\nmech 1\nlink rod B-C 5 mm\n```\n");
    for (const name of fixes) copyFileSync(join(root, "tests", "errors", `${name}.mech`), join(folder, fileOf(name)));
  }
}

/** Writes the settings, with the program to be taken. */
function choose(program) {
  for (const place of ["User", "Machine"]) {
    mkdirSync(join(home, "data", place), { recursive: true });
    writeFileSync(join(home, "data", place, "settings.json"), JSON.stringify({ ...settings, "assur.path": program }));
  }
}

/** VS Code's server, on a port of its choice. */
async function serve() {
  const options = ["--host", "127.0.0.1", "--port", "0", "--without-connection-token", "--accept-server-license-terms"];
  // no program of that name is on this path
  const env = { ...process.env, PATH: "/usr/bin:/bin" };
  const stdio = ["ignore", "pipe", "ignore"];
  const server = spawn(process.execPath, [main, ...options, ...places, "--telemetry-level", "off"], { env, stdio });
  const port = await new Promise((found, failed) => {
    let said = "";
    server.stdout.on("data", (part) => {
      said += part;
      const match = /listening on (\d+)/.exec(said);
      if (match) found(match[1]);
    });
    server.on("exit", () => failed(new Error(`the server ends: ${said}`)));
  });
  return { server, port };
}

async function open(page, port, { folder }) {
  await page.goto(`http://127.0.0.1:${port}/?folder=${folder}`);
  await page.locator(".explorer-folders-view").getByText("new.mech").waitFor();
}

/** Opens a file of the folder. */
async function show(page, file) {
  await page.locator(".explorer-folders-view").getByText(file, { exact: true }).dblclick();
  await page.locator(".tab.active", { hasText: file }).waitFor();
}

/** A picture for docs/pictures, when nothing moves any more. */
async function keep(page, name) {
  await page.waitForTimeout(1000);
  await page.screenshot({ path: join(process.env.PICTURES, `${name}.png`), clip: { x: 323, y: 36, width: 777, height: 400 } });
}

/** The colours of words of a line. */
async function colours(page, line, words) {
  const found = page.locator(".view-line", { hasText: line });
  const colour = (word) => found.locator("span span", { hasText: word }).first().evaluate((e) => getComputedStyle(e).color);
  return Promise.all(words.map(colour));
}

/** A whole problem by its snippet: there is nothing against it. */
async function insertSnippet(page) {
  await show(page, "new.mech");
  await page.locator(".monaco-editor .view-lines").first().click();
  await page.waitForTimeout(500);
  await page.keyboard.type("crank-slider", { delay: 20 });
  await page.locator(".suggest-widget", { hasText: "crank-slider" }).waitFor();
  await page.keyboard.press("Tab");
  await page.locator(".view-line", { hasText: /balance.torque.Mb.on.crank/ }).waitFor();
  await page.waitForTimeout(500);
  assert.equal(await page.locator(".squiggly-error").count(), 0, "a whole problem has no mistakes");
  await page.keyboard.press("Escape");
}

/** A block of Markdown that is marked as `mech` has the colours of a file. */
async function colourMarkdown(page) {
  await show(page, "notes.md");
  await page.locator(".view-line", { hasText: "rod" }).waitFor();
  const differs = async () => new Set(await colours(page, /link.rod/, ["link", "rod", "5"])).size === 3;
  for (let tries = 0; !(await differs()); tries += 1) {
    assert.ok(tries < 20, "words, names and numbers of a block in Markdown have colours of their own");
    await page.waitForTimeout(250);
  }
}

/** The frame of the picture in the preview, once it is there: of a page that the program serves, or of a panel. */
async function previewed(page, isPicture) {
  for (let tries = 0; ; tries += 1) {
    for (const frame of page.frames().filter(isPicture)) {
      if ((await frame.locator(".motion-slider").count().catch(() => 0)) === 1) return frame;
    }
    assert.ok(tries < 60, `a picture in the preview: ${page.frames().map((one) => one.url()).join(" ")}`);
    await page.waitForTimeout(250);
  }
}

/** The mechanism next to its text: the slider moves it, and it follows what is typed. */
async function movePreview(page, { name, isPicture }) {
  if (name === "program") {
    await page.keyboard.press("F1");
    await page.keyboard.type("Show the Mechanism to the Side");
    await page.locator(".quick-input-list", { hasText: "Show the Mechanism to the Side" }).waitFor();
    await page.keyboard.press("Enter");
  } else {
    await page.locator(".codelens-decoration a", { hasText: "picture" }).first().click();
  }
  const frame = await previewed(page, isPicture);
  const crank = () => frame.locator('g.link[data-name="crank"] line').first().evaluate((line) => line.getBoundingClientRect().x);
  const before = await crank();
  await frame.locator(".motion-slider").evaluate((slider) => { slider.value = slider.max / 4; slider.dispatchEvent(new Event("input")); });
  assert.notEqual(await crank(), before, "the slider moves the crank");
  // the cursor is at the rod
  await frame.locator('g.link.motion-marked[data-name="rod"]').first().waitFor({ state: "attached" });
  if (process.env.PICTURES) await page.screenshot({ path: join(process.env.PICTURES, `vscode-preview-${name}.png`) });
  await page.keyboard.press("Escape");
  await page.locator(".tab", { hasText: "engine.mech" }).first().click();
  await page.keyboard.press("Control+w");
  await page.keyboard.press("Control+k");
  await page.keyboard.press("Control+w");
  await page.locator(".tab").first().waitFor({ state: "detached" });
}

/** Waits for the bulb at a fix: VS Code offers nothing while it still asks for it, and asks once more when the cursor moves if what it
 * knows of another file changed meanwhile. */
async function bulb(page) {
  const shown = page.locator("[class*=lightbulb]:visible, [class*=light-bulb]:visible").first();
  for (let tries = 0; tries < 3; tries += 1) {
    if (await shown.waitFor({ timeout: 4000 }).then(() => true, () => false)) return;
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowRight");
  }
  await shown.waitFor();
}

/** Goes to the only problem of a file and accepts what is offered, by keyboard. */
async function acceptFix(page, file) {
  await show(page, file);
  await page.locator(".squiggly-error").first().waitFor();
  await page.keyboard.press("F8");
  await page.locator(".marker-widget").waitFor();
  await bulb(page);
  await page.keyboard.press("Control+.");
  await page.locator(".action-widget").waitFor();
  await page.keyboard.press("Enter");
  await page.locator(".squiggly-error").first().waitFor({ state: "detached" });
  await page.keyboard.press("Escape");
}

/** The page of a diagnostic, offered behind its fixes. */
async function explain(page) {
  await page.locator(".action-widget").getByText("explain `mech::name::unknown`").waitFor();
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  const tab = page.locator(".tab", { hasText: "Preview" });
  await tab.click();
  const isPage = (frame) => frame.locator("h1", { hasText: "mech::name::unknown" }).count().catch(() => 0);
  for (let tries = 0; !(await Promise.all(page.frames().map(isPage))).includes(1); tries += 1) {
    assert.ok(tries < 60, "the page of the diagnostic");
    await page.waitForTimeout(250);
  }
  await page.keyboard.press("Control+w");
  await tab.waitFor({ state: "detached" });
}

/** Opens the list of what can be done with the mistake. */
async function offer(page) {
  await page.locator(".view-line", { hasText: "prismatic" }).click();
  await page.locator(".view-line", { hasText: "rodd" }).locator("span span", { hasText: "rodd" }).last().click();
  await bulb(page);
  await page.keyboard.press("Control+.");
  await page.locator(".action-widget").getByText("write `rod`").waitFor();
}

/** What VS Code shows over a word of a line of the same name: it shows nothing where the line is drawn anew meanwhile. */
async function hoverOver(page, word) {
  const shown = page.locator(".monaco-hover:visible", { hasText: word }).first();
  for (let tries = 0; tries < 3; tries += 1) {
    await page.locator(".view-line", { hasText: word }).locator("span span", { hasText: word }).last().hover();
    if (await shown.waitFor({ timeout: 4000 }).then(() => true, () => false)) return shown;
    await page.mouse.move(0, 0);
  }
  await shown.waitFor();
  return shown;
}

/** What is done with a mistake, with one of the servers. */
async function correct(page, server) {
  await show(page, "engine.mech");
  await page.locator(".view-line", { hasText: "prismatic" }).waitFor();
  await page.locator("[id='assur.mech.assur']").getByText(server.status).waitFor();
  const differs = async () => new Set(await colours(page, "prismatic", ["prismatic", "D"])).size === 2;
  for (let tries = 0; !(await differs()); tries += 1) {
    assert.ok(tries < 20, "words of the language and names have different colours");
    await page.waitForTimeout(250);
  }
  await page.locator(".squiggly-error").first().waitFor();
  assert.equal(await page.locator(".squiggly-error").count(), 1, "one mistake");

  const hover = await hoverOver(page, "rodd");
  assert.match(await hover.innerText(), /did you mean `rod`/);
  if (process.env.PICTURES && server.name === "program") await keep(page, "vscode-hover");

  await page.keyboard.press("Escape");
  await offer(page);
  await explain(page);
  await offer(page);
  if (process.env.PICTURES && server.name === "program") await keep(page, "vscode-fix");
  await page.keyboard.press("Enter");
  await page.locator(".view-line", { hasText: /crank.-.rod$/ }).waitFor();
  await page.locator(".squiggly-error").waitFor({ state: "detached" });

  await page.keyboard.press("Control+Shift+I");
  await page.locator(".view-line", { hasText: /^given.n.=.1500/ }).waitFor();
  await page.keyboard.press("Control+s");
  await movePreview(page, server);
  for (const name of fixes) await acceptFix(page, fileOf(name));
  const saved = readFileSync(join(server.folder, "engine.mech"), "utf8");
  assert.equal(saved, text.replace("given   n", "given n").replace("rodd", "rod"));
}

async function test(page, port) {
  await open(page, port, servers.program);
  await correct(page, servers.program);
  await colourMarkdown(page);
  await insertSnippet(page);

  choose("/no/such/assur");
  await page.getByText("/no/such/assur, which is not a program").first().waitFor();
  choose(join(home, "assur"));
  await page.getByText("is assur 9.1.0; this extension is for").first().waitFor();
  choose("");
  await open(page, port, servers.builtIn);
  await correct(page, servers.builtIn);
}

prepare();
const { server, port } = await serve();
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const page = await browser.newPage({ viewport: { width: 1100, height: 640 } });
page.setDefaultTimeout(15_000);
try {
  await test(page, port);
  console.log(`VS Code, program and built-in server: colours, mistake, hover, its page, format, ${fixes.length + 1} fixes by keyboard, preview; Markdown, snippet, choice of the server`);
} catch (error) {
  await page.screenshot({ path: join(tmpdir(), "assur-workbench.png") });
  console.error(`the picture of the failure is ${join(tmpdir(), "assur-workbench.png")}`);
  throw error;
} finally {
  await browser.close();
  server.kill();
  rmSync(home, { recursive: true, force: true });
}
