// node --test viewer.test.mjs, with FOAMSIM (the program) and SCRATCH (a folder for runs and pictures): an exported run in a
// browser loads, plays, picks, cuts and explodes, by mouse and by keys, with nothing on the console.
import assert from 'node:assert/strict';
import {execFileSync, spawn} from 'node:child_process';
import {mkdirSync, rmSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {chromium, launch, openPage} from './page.mjs';

const {FOAMSIM: program, SCRATCH: scratch} = process.env;
const skip = chromium ? false : 'there is no chromium';
const run = join(scratch, 'run'), file = join(scratch, 'run.html');
const foamsim = (...words) => execFileSync(program, words, {stdio: ['ignore', 'pipe', 'inherit']});
let browser;

before(async () => {
  if (skip) return;
  rmSync(scratch, {recursive: true, force: true});
  mkdirSync(scratch, {recursive: true});
  foamsim('run', 'doublebubble', '--set', 'n=8', '--set', 'vtp=true', '--set', 'frame_every=2', '--steps', '8', '--quiet', '--out', run);
  foamsim('export-web', run, file, '--quiet');
  browser = await launch();
});
after(() => browser?.close());

// A test that fails leaves its page open; its timeout is the file's.
async function withPage(where, act, viewport) {
  const {page, complaints} = await openPage(browser, where, viewport);
  await act(page);
  assert.deepEqual(complaints, []);
  await page.close();
}

const settled = page => page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));

async function picture(page, name) {
  await settled(page);
  const path = join(scratch, `${name}.png`);
  await page.screenshot({path});
  return path;
}

// Share of the view's pixels that are drawn, and a checksum that tells one picture from another.
const drawn = page => page.evaluate(() => {
  const {canvas, renderer} = window.foamsim.view;
  window.foamsim.view.drawNow();
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let covered = 0, sum = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    const light = pixels[i] + pixels[i + 1] + pixels[i + 2];
    if (light > 12) ++covered;
    sum = (sum * 31 + light) >>> 0;
  }
  return {share: covered / (pixels.length / 4), sum, width: canvas.width};
});

test('loads and draws the films as glass', {skip}, () => withPage(file, async page => {
  assert.equal(await page.$eval('#scene', e => e.textContent), 'doublebubble');
  assert.equal(await page.$eval('#state', e => e.textContent), 'finished');
  const {share} = await drawn(page);
  assert.ok(share > 0.08 && share < 0.9, `${share} of the view is drawn`);
  await picture(page, 'glass');
}));

test('every colouring gives another picture, fields with a legend', {skip}, () => withPage(file, async page => {
  const names = await page.$$eval('#colour option', options => options.map(option => option.value));
  for (const name of ['glass', 'bubbles', 'field/mean_curvature', 'field/pressure_jump', 'field/circulation']) assert.ok(names.includes(name), name);
  const sums = new Set();
  for (const name of ['glass', 'bubbles', 'field/mean_curvature']) {
    await page.select('#colour', name);
    await settled(page);
    sums.add((await drawn(page)).sum);
    assert.equal(await page.$eval('#legend', e => e.hidden), !name.startsWith('field/'));
  }
  assert.equal(sums.size, 3);
  assert.match(await page.$eval('#legend', e => e.getAttribute('aria-label')), /mean curvature .* from .* to /);
  await picture(page, 'field');
}));

test('plays, pauses and seeks, and films move', {skip}, () => withPage(file, async page => {
  const clock = () => page.$eval('#clock', e => e.textContent);
  assert.match(await clock(), /1\/5/);
  const first = (await drawn(page)).sum;
  await page.click('#play');
  await page.waitForFunction(() => window.foamsim.index > 1, {timeout: 60000});
  await page.click('#play');
  assert.equal(await page.$eval('#play', e => e.getAttribute('aria-label')), 'Play');
  await page.evaluate(() => window.foamsim.seek(4));
  assert.match(await clock(), /step 8 · 5\/5/);
  assert.notEqual((await drawn(page)).sum, first);
}));

test('a click picks a bubble and shows its numbers and history', {skip}, () => withPage(file, async page => {
  const box = await (await page.$('#view')).boundingBox();
  // The middle of bubble 1 on the screen.
  const at = await page.evaluate(() => {
    const {view, frame} = window.foamsim;
    const [x, y, z] = frame.bubbles.get(1).centre;
    const p = view.camera.position.clone().set(x, y, z).project(view.camera);
    return [(p.x + 1) / 2 * view.canvas.clientWidth, (1 - p.y) / 2 * view.canvas.clientHeight];
  });
  await page.mouse.click(box.x + at[0], box.y + at[1]);
  assert.ok([1, 2].includes(await page.evaluate(() => window.foamsim.view.look.picked)));
  const values = await page.$eval('#bubble-values', e => e.innerText);
  for (const word of ['volume', 'area', 'pressure', 'faces', 'L³']) assert.ok(values.includes(word), values);
  assert.equal(await page.$eval('#history-plot', e => e.hidden), false);
  assert.match(await page.$eval('#announce', e => e.textContent), /bubble [12]/);
  await picture(page, 'picked');
  await page.mouse.click(box.x + 4, box.y + 4);
  assert.equal(await page.evaluate(() => window.foamsim.view.look.picked), -1);
}));

test('cut and explosion change what is drawn', {skip}, () => withPage(file, async page => {
  await page.select('#colour', 'bubbles');
  const whole = await drawn(page);
  await page.select('#cut-axis', 'x');
  const cut = await drawn(page);
  assert.ok(cut.sum !== whole.sum);
  await picture(page, 'cut');
  await page.select('#cut-axis', '');
  await page.evaluate(() => {
    const slider = document.getElementById('explode');
    slider.value = '0.8';
    slider.dispatchEvent(new Event('input', {bubbles: true}));
  });
  const apart = await drawn(page);
  assert.ok(apart.share > whole.share, `${apart.share} of the view against ${whole.share}`);
  await picture(page, 'explode');
}));

test('everything works by keys, with the focus to be seen', {skip}, () => withPage(file, async page => {
  const state = () => page.evaluate(() => {
    const {index, playing, view} = window.foamsim;
    return {index, playing, picked: view.look.picked, glass: view.look.glass, borders: view.look.borders, explode: view.look.explode, cut: view.look.cut, x: view.camera.position.x};
  });
  const start = await state();
  await page.focus('#view');
  await page.keyboard.press('End');
  await page.waitForFunction(() => window.foamsim.index === 4);
  for (const key of ['m', 'b', 'e', 'c', ']']) await page.keyboard.press(key);
  await page.keyboard.down('Shift');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.up('Shift');
  const now = await state();
  assert.deepEqual([now.glass, now.borders, now.explode > 0, now.cut, now.picked], [false, false, true, 'x', 1]);
  assert.notEqual(now.x, start.x);
  await page.keyboard.press('Escape');
  assert.equal((await state()).picked, -1);
  await page.keyboard.press('?');
  assert.ok(await page.$eval('#help', e => e.open));
  await page.keyboard.press('Escape');
  const outlined = [];
  for (let i = 0; i < 6; ++i) {
    await page.keyboard.press('Tab');
    outlined.push(await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle));
  }
  assert.ok(outlined.every(style => style !== 'none'), outlined.join());
}));

test('controls have names and text has contrast', {skip}, () => withPage(file, async page => {
  const nameless = await page.$$eval('button, select, input, canvas', elements => elements.filter(e =>
    !(e.labels?.length || e.getAttribute('aria-label') || e.textContent.trim() || e.closest('[role=img]'))).map(e => e.id));
  assert.deepEqual(nameless, []);
  // WCAG 2: relative luminances of text and the nearest ground behind it.
  const poor = await page.evaluate(() => {
    const parts = colour => colour.match(/[\d.]+/g).map(Number);
    const luminance = ([r, g, b]) => [r, g, b].map(c => c / 255).map(c => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)).reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
    const ground = element => {
      for (let e = element; e; e = e.parentElement) {
        const colour = parts(getComputedStyle(e).backgroundColor);
        if (colour.length === 3 || colour[3] > 0.5) return colour;
      }
      return [0, 0, 0];
    };
    return [...document.querySelectorAll('h1, h2, p, label, button, select, output, dt, dd')].filter(e => e.offsetParent && e.textContent.trim()).filter(e => {
      const [a, b] = [luminance(parts(getComputedStyle(e).color)), luminance(ground(e))].sort((x, y) => y - x);
      return (a + 0.05) / (b + 0.05) < 4.5;
    }).map(e => e.id || e.textContent.trim());
  });
  assert.deepEqual(poor, []);
}));

test('fits a telephone, and a tap picks', {skip}, () => withPage(file, async page => {
  const wide = await page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth);
  assert.equal(wide, false);
  const box = await (await page.$('#view')).boundingBox();
  assert.ok(box.height > 200, `${box.height} pixels for the view`);
  await page.evaluate(() => window.foamsim.view.fit());
  await page.touchscreen.tap(box.x + box.width / 2 - 40, box.y + box.height / 2);
  await page.touchscreen.tap(box.x + box.width / 2 + 40, box.y + box.height / 2);
  await picture(page, 'telephone');
}, {width: 390, height: 800, hasTouch: true, isMobile: true}));

test('a served run is shown, and its server ends as it is told', {skip}, async () => {
  const server = spawn(program, ['view', run], {stdio: ['ignore', 'pipe', 'inherit']});
  try {
    const address = await new Promise((found, failed) => {
      server.stdout.once('data', text => found(String(text).split('\n')[0]));
      server.once('exit', code => failed(new Error(`foamsim view ended with ${code}`)));
    });
    await withPage(address, async page => {
      assert.ok((await drawn(page)).share > 0.08);
      await page.evaluate(() => window.foamsim.seek(3));
      assert.match(await page.$eval('#clock', e => e.textContent), /4\/5/);
    });
    const other = await fetch(new URL('/run.json', address));
    assert.equal(other.status, 404);
  } finally {
    if (server.exitCode === null) {
      server.kill('SIGINT');
      await new Promise(ended => server.once('exit', ended));
    }
    assert.equal(server.exitCode, 130);
  }
});

test('pictures are not empty', {skip}, () => {
  for (const name of ['glass', 'field', 'picked', 'cut', 'explode', 'telephone']) assert.ok(statSync(join(scratch, `${name}.png`)).size > 10000, name);
});
