// Bundles the page and writes it to the assets of the Rust crate; with `--planner` also the planner, as compiled to
// `planner/` by `make viewer`.

import { createHash } from 'node:crypto';
import { copyFile, mkdir, readFile, readdir, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { inflateRawSync } from 'node:zlib';
import { deflateAsync } from '@gfx/zopfli';
import { build } from 'esbuild';
import { encode } from './src/base85.js';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const assets = '../crates/cdpr-view/src/assets/';
const licence = here('node_modules/three/LICENSE');
const placeholders = ['{{title}}', '/*{{style}}*/', '{{data}}', '{{worker}}', '{{module}}', '/*{{script}}*/'];

// What each asset is made from: a change of these needs `make viewer`.
const sources = {
  page: ['src', 'build.mjs', 'package-lock.json'],
  planner: ['../crates/cdpr-core/src', '../crates/cdpr-view/src', '../crates/cdpr-live/src', 'src/worker.js', 'src/base85.js', 'package-lock.json'],
};

const shared = { bundle: true, minify: true, write: false, target: 'es2020', legalComments: 'none' };

async function bundle(options) {
  const result = await build({ ...shared, ...options });
  return result.outputFiles[0].text;
}

async function bundleScript() {
  const notice = (await readFile(licence, 'utf8')).trim().replaceAll('©', '(c)');
  return bundle({
    entryPoints: [here('src/main.js')],
    format: 'iife',
    banner: { js: `/*! Contains three.js.\n\n${notice}\n*/` },
  });
}

// The glue of wasm-bindgen mentions `import.meta`, which the worker never uses.
const bundleWorker = () =>
  bundle({ entryPoints: [here('src/worker.js')], format: 'iife', logOverride: { 'empty-import-meta': 'silent' } });

// Text placed within a page must not end its element nor look like a placeholder.
function checkInline(name, content) {
  const forbidden = ['</script', '</style', '<!--', ...placeholders];
  const found = forbidden.filter((sequence) => content.toLowerCase().includes(sequence));
  if (found.length > 0) throw new Error(`${name} contains ${found.join(' and ')}`);
}

function checkTemplate(template) {
  for (const placeholder of placeholders) {
    if (template.split(placeholder).length !== 2) throw new Error(`the template must contain ${placeholder} once`);
  }
}

async function write(name, content) {
  await mkdir(here(assets), { recursive: true });
  await writeFile(here(`${assets}${name}`), content);
  console.log(`${name} ${Math.round(content.length / 1024)} KiB`);
}

async function writePage() {
  const script = await bundleScript();
  const style = await bundle({ entryPoints: [here('src/viewer.css')], target: ['chrome111', 'firefox121', 'safari16.4'] });
  const template = await readFile(here('src/template.html'), 'utf8');
  checkInline('viewer.js', script);
  checkInline('viewer.css', style);
  checkTemplate(template);
  await write('viewer.js', script);
  await write('viewer.css', style);
  await write('template.html', template);
  await copyFile(licence, here(`${assets}THREE_LICENSE.txt`));
}

// Deflated, 5 % smaller than by zlib.
async function deflated(content) {
  const raw = Buffer.from(await deflateAsync(content, {}));
  if (!inflateRawSync(raw).equals(content)) throw new Error('the deflated planner is not the planner');
  return raw;
}

async function writePlanner() {
  const worker = await bundleWorker();
  checkInline('worker.js', worker);
  await write('worker.js', worker);
  const packed = encode(await deflated(await readFile(here('planner/planner.wasm'))));
  checkInline('planner.txt', packed);
  await write('planner.txt', packed);
}

// The names of the files in a folder in order, without the assets that are built; or the name of the file itself.
async function files(path) {
  const entries = await readdir(here(path), { withFileTypes: true, recursive: true }).catch(() => null);
  if (entries === null) return [path];
  const inside = entries.filter((entry) => entry.isFile()).map((entry) => `${entry.parentPath}/${entry.name}`);
  const sources = inside.map((file) => `${path}${file.slice(here(path).length)}`);
  return sources.filter((file) => !file.includes('/assets/')).sort();
}

// What is compiled of a Rust file: neither its unit tests nor its comments, so that a change of those rebuilds nothing.
function compiled(rust) {
  const tests = /^#\[cfg\(test\)\]\nmod \w+ \{\n[^]*?^\}\n/gm;
  return rust.replace(tests, '').replace(/^[ \t]*(\/\/.*)?\n/gm, '');
}

async function checksum(paths) {
  const hash = createHash('sha256');
  for (const path of (await Promise.all(paths.map(files))).flat()) {
    const bytes = await readFile(here(path));
    hash.update(path.endsWith('.rs') ? compiled(bytes.toString()) : bytes);
  }
  return hash.digest('hex');
}

// The tests compare these checksums with the sources.
async function writeChecksum(asset) {
  await writeFile(here(`${assets}${asset}.sha256`), `${await checksum(sources[asset])}\n`);
}

if (process.argv.includes('--planner')) {
  await writePlanner();
  await writeChecksum('planner');
} else {
  await writePage();
  await writeChecksum('page');
}
