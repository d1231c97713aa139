// node bundle.mjs OUT.cpp: the viewer's page, scripts and styles in it, as a C++ source that returns it.
import {build} from 'esbuild';
import {readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2];
if (!output) throw new Error('usage: node bundle.mjs OUT.cpp');

const bundled = await build({
  entryPoints: [join(here, 'src/main.js')],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  legalComments: 'inline',
  charset: 'ascii',
  write: false,
  logLevel: 'warning',
});
const styles = await build({entryPoints: [join(here, 'src/style.css')], minify: true, write: false, logLevel: 'warning'});

const script = bundled.outputFiles[0].text.replaceAll('</script', '<\\/script');
let page = readFileSync(join(here, 'src/page.html'), 'utf8');
for (const [mark, text] of [['/* style */', styles.outputFiles[0].text], ['/* script */', script]]) {
  if (page.split(mark).length !== 2) throw new Error(`page.html has to have ${mark} once`);
  page = page.replace(mark, () => text);
}

const delimiter = 'viewer_page';
if (page.includes(`)${delimiter}"`)) throw new Error('the page has the end of a C++ raw string');
// One literal, longer than the 65,536 characters that the standard asks of every compiler; GCC and clang have no bound, and
// clang's -Wpedantic reminds of the standard's.
writeFileSync(output, `#include "FoamSim/web/viewer_page.h"

#pragma GCC diagnostic ignored "-Woverlength-strings"

namespace foamsim::web {

std::string_view viewer_page() {
  static constexpr char page[] = R"${delimiter}(${page})${delimiter}";
  return {page, sizeof(page) - 1};
}

}  // namespace foamsim::web
`);
