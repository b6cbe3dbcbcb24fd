// The times of the page: how fast it opens, follows, and moves. Prints a table; asserts nothing, as machines differ.

import { readFileSync } from "node:fs";
import { chromium } from "playwright-core";
import { serve } from "../serve.mjs";

const { address, server } = await serve();
const all = JSON.parse(readFileSync(new URL("../dist/examples.json", import.meta.url), "utf8")).filter((one) => one.chapter);
const median = (numbers) => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
const ms = (time) => `${Math.round(time)} ms`;

async function browser(slow, mbit) {
  const own = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
  const page = await own.newPage({ viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(120_000);
  const session = await page.context().newCDPSession(page);
  if (slow > 1) await session.send("Emulation.setCPUThrottlingRate", { rate: slow });
  if (mbit) await session.send("Network.emulateNetworkConditions", { offline: false, latency: 40, downloadThroughput: (mbit * 1e6) / 8, uploadThroughput: (mbit * 1e6) / 8 });
  return { own, page };
}

const ready = (page, least = 1) => page.waitForFunction((count) => Number(document.body.dataset.ready) >= count, least, { polling: "raf" });

/** From the begin of loading to the mechanism that can move. */
async function opens(slow, mbit, again) {
  const { own, page } = await browser(slow, mbit);
  const times = [];
  for (let i = 0; i <= (again ? 1 : 0); i += 1) {
    await page.goto("about:blank");
    const begin = performance.now();
    await page.goto(`${address}#x/crank-slider`, { waitUntil: "commit" });
    await ready(page);
    times.push(performance.now() - begin);
  }
  await own.close();
  return times.at(-1);
}

/** A digit changes in each example: until its diagnostics, until the picture of the pose, until the whole motion. */
async function follows(slow) {
  const { own, page } = await browser(slow);
  await page.goto(`${address}#x/first`);
  await ready(page);
  const found = { diagnostics: [], picture: [], motion: [], frames: [] };
  for (const { text } of all) {
    const times = await page.evaluate(async (content) => {
      const editor = document.querySelector(".cm-content"), picture = document.getElementById("picture");
      const paste = (inner) => {
        getSelection().selectAllChildren(editor);
        const data = new DataTransfer();
        data.setData("text/plain", inner);
        editor.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
      };
      const count = () => Number(document.body.dataset.ready);
      const until = async (holds) => {
        while (!holds()) await new Promise((next) => setTimeout(next, 2));
      };
      const quiet = async () => {
        for (let last = -1; last !== count(); await new Promise((next) => setTimeout(next, 800))) last = count();
      };
      let before = count();
      editor.focus();
      paste(content);
      await until(() => count() > before);
      await quiet();
      // the last digit of a length or an angle
      const digit = /(\d)(?= (?:mm|m|deg)\b)/g, places = [...content.matchAll(digit)];
      const at = places[Math.floor(places.length / 2)].index;
      const other = content.slice(0, at) + ((Number(content[at]) + 1) % 10) + content.slice(at + 1);
      before = count();
      const seen = { diagnostics: 0, picture: 0 };
      const tabs = new MutationObserver(() => (seen.diagnostics ||= performance.now()));
      tabs.observe(document.getElementById("pane-problems"), { childList: true, subtree: true });
      const drawn = new MutationObserver(() => (seen.picture ||= performance.now()));
      drawn.observe(picture, { childList: true });
      const begin = performance.now();
      paste(other);
      // a digit may leave no position
      await until(() => count() > before || performance.now() > begin + 10_000);
      const motion = count() > before ? performance.now() : 0;
      tabs.disconnect();
      drawn.disconnect();
      before = count();
      paste(content);
      await until(() => count() > before);
      await new Promise((next) => setTimeout(next, 300));
      const choice = document.querySelector(".motion-show");
      if (choice?.querySelector("option[value=reactions]:not([data-missing])")) {
        choice.value = "reactions";
        choice.dispatchEvent(new Event("change"));
      }
      let frames = 0, on = true;
      const step = () => on && ((frames += 1), requestAnimationFrame(step));
      document.querySelector(".motion-play")?.click();
      requestAnimationFrame(step);
      await new Promise((next) => setTimeout(next, 1000));
      on = false;
      document.querySelector(".motion-play")?.click();
      return { diagnostics: seen.diagnostics - begin, picture: seen.picture - begin, motion: motion - begin, frames };
    }, text);
    for (const key of Object.keys(found)) if (times[key] > 0) found[key].push(times[key]);
  }
  await own.close();
  return `${ms(median(found.diagnostics))} | ${ms(median(found.picture))} | ${ms(median(found.motion))} | ${Math.min(...found.frames)} to ${Math.max(...found.frames)}`;
}

console.log("| opens: the crank-slider moves | |\n| --- | ---: |");
console.log(`| empty cache, 10 Mbit/s, processor ÷ 4 (bar 3.5 s) | ${ms(await opens(4, 10, false))} |`);
console.log(`| warm cache, processor ÷ 4 (bar 1.5 s) | ${ms(await opens(4, 0, true))} |`);
console.log(`| warm cache, full speed | ${ms(await opens(1, 0, true))} |`);
console.log("\n| follows: a digit changes in each of 24 examples, medians | diagnostics | picture | motion | frames a second |\n| --- | ---: | ---: | ---: | ---: |");
console.log(`| full speed (bars 50, 60, 400 ms, 55) | ${await follows(1)} |`);
console.log(`| processor ÷ 4 (bars 150, 180, 1200 ms, 30) | ${await follows(4)} |`);
server.close();
