// A test is a function that throws; each is named, timed and counted.

export async function run(tests) {
  const filter = process.env.FILTER ?? "";
  const failed = [];
  let count = 0;
  for (const [name, test] of Object.entries(tests)) {
    if (!name.includes(filter)) continue;
    const begin = performance.now();
    count += 1;
    try {
      const said = await test();
      console.log(`ok    ${name}${said ? `: ${said}` : ""} (${((performance.now() - begin) / 1000).toFixed(1)} s)`);
    } catch (error) {
      failed.push(name);
      console.log(`WRONG ${name}\n${error.stack ?? error}`);
    }
  }
  console.log(`${count - failed.length} of ${count} tests passed`);
  process.exit(failed.length > 0 ? 1 : 0);
}
