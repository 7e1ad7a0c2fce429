// Bundles the viewer and writes it to the assets of the Rust crate.

import { copyFile, mkdir, readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const assets = '../crates/cdpr-view/src/assets/';
const licence = here('node_modules/three/LICENSE');
const placeholders = ['{{title}}', '/*{{style}}*/', '{{data}}', '/*{{script}}*/'];

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

const script = await bundleScript();
const style = await bundle({ entryPoints: [here('src/viewer.css')], target: ['chrome111', 'firefox121', 'safari16.4'] });
const template = await readFile(here('src/template.html'), 'utf8');
checkInline('viewer.js', script);
checkInline('viewer.css', style);
checkTemplate(template);

await mkdir(here(assets), { recursive: true });
await writeFile(here(`${assets}viewer.js`), script);
await writeFile(here(`${assets}viewer.css`), style);
await writeFile(here(`${assets}template.html`), template);
await copyFile(licence, here(`${assets}THREE_LICENSE.txt`));
console.log(`viewer.js ${Math.round(script.length / 1024)} KiB, viewer.css ${Math.round(style.length / 1024)} KiB`);
