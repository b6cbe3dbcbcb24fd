// Every snippet, with the texts of its placeholders, in a file that it fits: `assur check` has nothing against it.
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";

const assur = process.env.ASSUR ?? "assur";
const snippets = JSON.parse(readFileSync(new URL("../snippets/mech.json", import.meta.url), "utf8"));

const ground = "ground { A (0, 0); line guide through A along 0 deg }\n";
const links = `${ground}link crank A-B 100 mm
link rod B-C 350 mm { S (100 mm, 0); mass 2.5 kg at S; inertia 0.04 kg*m^2 }
link piston { C (0, 0) }
`;
const hinges = "revolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - piston\n";
const guide = "prismatic D: piston.C - ground.guide\n";
const machine = links + hinges + guide;
const drive = "drive crank = 45 deg at 1500 rpm\n";
const assemble = "assemble C ahead of B\n";
const balanced = `${machine}${drive}${assemble}balance torque Mb on crank\nfind Mb\n`;
const moving = "gravity 9.81 m/s^2\nground { A (0, 0) }\nlink crank A-B 100 mm { mass 1 kg at B; inertia 0.01 kg*m^2 }\nrevolute A: ground - crank\n";
const start = "start crank = 5 deg\n";
const wheels = "shaft I { wheel z1 radius 100 mm }\nshaft II { wheel z2 radius 200 mm }\ndrive I at 100 rpm\nfind omega(II)\n";

// What is before and after a snippet, by its prefix or, where several have one, by its name.
const around = {
  link: ["ground { B (0, 0) }\nrevolute B: ground - rod\ndrive rod = 30 deg\n", "find position(rod.C)\n"],
  shaft: ["drive I at 100 rpm\nfind omega(I)\n", ""],
  slider: ["drive piston = 100 mm\nfind displacement(piston)\n", ""],
  let: ["given r = 100 mm\n", ""],
  spring: [balanced, ""],
  "spring in": [balanced, ""],
  all: [balanced, ""],
  group: [balanced, ""],
  drive: [machine + assemble, "find velocity(C)\n"],
  "drive in steps": [machine + assemble, "find velocity(C)\n"],
  pose: [balanced, ""],
  assemble: [machine + drive, ""],
  "assemble left": [machine + drive, ""],
  balance: [machine + drive + assemble, "find M\n"],
  "balance force": [machine + drive + assemble, "find F\n"],
  force: [balanced, ""],
  "force against motion": [balanced, ""],
  torque: [balanced, ""],
  brake: [balanced, ""],
  flywheel: [balanced.replace("45 deg", "0 deg .. 360 deg in 12 steps"), ""],
  find: [balanced, ""],
  "find reactions": [balanced, ""],
  expect: [balanced, ""],
  variants: ["given r = 100 mm\ngiven l = 350 mm\nfind s = r + l\n", ""],
  start: [moving, "simulate 1 s in 10 steps\nfind omega(crank)\n"],
  simulate: [moving + start, "find omega(crank)\n"],
  event: [moving + start, "simulate 1 s in 10 steps\nfind omega(crank)\n"],
  until: [moving + start, "simulate 1 s in 10 steps\nfind omega(crank)\n"],
  stop: [moving + start, "simulate 1 s in 10 steps\nfind omega(crank)\n"],
  ignore: [balanced, ""],
  revolute: [links + hinges.replace(/revolute B.*\n/, "") + guide + drive + assemble, ""],
  weld: [
    `${links.replace(/link piston.*\n/, "")}revolute A: ground - crank\n${drive}`,
    "find angle(rod)\n",
  ],
  prismatic: [links + hinges + drive + assemble, ""],
  slot: [links.replace(/link piston.*\n/, "") + "revolute A: ground - crank\nrevolute B: crank - rod\n" + drive + "assemble K > 0\n", ""],
  contact: [
    `ground { A (0, 0); C (-110 mm, 20 mm) }
link cam A-O 15 mm { circle rim centre O radius 40 mm }
link lever { C (0, 0); P (0, -8 mm); S (80 mm, 5 mm); line face through P along 0 deg }
revolute A: ground - cam
revolute C: ground - lever
drive cam = 0 deg at 10 rad/s
assemble lever.S near (-30 mm, 70 mm)
`,
    "",
  ],
  cylinder: [
    "ground { A (0, 0); O (300 mm, 0) }\nlink rod O-C 200 mm\nrevolute O: ground - rod\ndrive c1 = 350 mm\nassemble C left of A-O\n",
    "find angle(rod)\n",
  ],
  mesh: [wheels, ""],
  belt: [wheels, ""],
  chain: [wheels, ""],
  rack: [
    `ground { O (0, 0); line guide through O along 0 deg }
link bar { C (0, 0); line teeth through C along 0 deg }
prismatic D: bar.C - ground.guide
shaft I { wheel z1 teeth 24 module 5 mm }
drive I = 0 deg at 2 rad/s
`,
    "find displacement(D)\n",
  ],
  rope: ["shaft winch { wheel drum radius 80 mm }\nslider load\ndrive winch at 30 rpm\n", "find velocity(load)\n"],
  worm: ["shaft motor\nshaft drum { wheel z2 teeth 40 }\ndrive motor at 1450 rpm\n", "find omega(drum)\n"],
  screw: ["shaft spindle\nslider nut\ndrive spindle at 30 rpm\n", "find velocity(nut)\n"],
  clutch: ["shaft I\nshaft II\ndrive I at 300 rpm\nbrake M on II { capacity 5 N*m }\n", "find moment(c, II)\n"],
};

/** A snippet's text with the first choice at every place. */
function plain(body) {
  const lines = Array.isArray(body) ? body.join("\n") : body;
  return lines.replace(/\$\{\d+\|([^,|]*)[^|]*\|\}/g, "$1").replace(/\$\{\d+:([^}]*)\}/g, "$1").replace(/\$\d/g, "");
}

let failed = 0;
for (const [name, { prefix, body }] of Object.entries(snippets)) {
  const [before, after] = around[prefix] ?? ["", ""];
  const text = `${before}${plain(body)}\n${after}`;
  const { status, stdout, stderr, error } = spawnSync(assur, ["check", "-"], { input: text, encoding: "utf8" });
  if (error) throw error;
  if (status !== 0 || /warning|⚠/.test(stderr)) {
    failed += 1;
    console.error(`${name}:\n${text}\n${stderr || stdout}`);
  }
}
console.log(`${Object.keys(snippets).length} snippets, ${failed} with problems`);
process.exit(failed > 0 ? 1 : 0);
