// Serves the folder `dist` on loopback.

import { createServer } from "node:http";
import { createReadStream, readFileSync, statSync } from "node:fs";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".json": "application/json", ".svg": "image/svg+xml", ".gz": "application/gzip", ".mech": "text/plain" };
const DIST = fileURLToPath(new URL("dist/", import.meta.url));

/** Texts, which servers of files send packed. */
const PACKED = new Set([".html", ".js", ".css", ".json", ".svg"]);
const known = new Map();
function packed(file) {
  const { mtimeMs } = statSync(file);
  if (known.get(file)?.mtimeMs !== mtimeMs) known.set(file, { mtimeMs, body: gzipSync(readFileSync(file)) });
  return known.get(file).body;
}

/** Serves a folder; gives the address and the server. */
export function serve(folder = DIST, port = 0) {
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://a").pathname);
    let file = join(folder, normalize(path));
    try {
      if (statSync(file).isDirectory()) file = join(file, "index.html");
      if (PACKED.has(extname(file)) && /\bgzip\b/.test(request.headers["accept-encoding"] ?? "")) {
        const body = packed(file);
        response.writeHead(200, { "Content-Type": TYPES[extname(file)], "Content-Encoding": "gzip", "Content-Length": body.length });
        response.end(body);
        return;
      }
      const { size } = statSync(file);
      response.writeHead(200, { "Content-Type": TYPES[extname(file)] ?? "application/octet-stream", "Content-Length": size });
      createReadStream(file).pipe(response);
    } catch {
      response.writeHead(404).end();
    }
  });
  return new Promise((resolve, reject) => {
    server.once("error", reject);
    server.listen(port, "127.0.0.1", () => resolve({ address: `http://127.0.0.1:${server.address().port}/`, server }));
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { address } = await serve(DIST, Number(process.argv[2] ?? 8000));
  console.log(`the playground is at ${address}`);
}
