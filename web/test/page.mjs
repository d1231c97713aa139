// A browser with an exported run in it, and what it complained of.
import {existsSync} from 'node:fs';
import {pathToFileURL} from 'node:url';
import puppeteer from 'puppeteer-core';

const programs = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
export const chromium = programs.find(program => program && existsSync(program));

// Without a graphics processor, as on a server.
export const launch = () => puppeteer.launch({
  executablePath: chromium, headless: true,
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});

export async function openPage(browser, where, viewport = {width: 1280, height: 800}) {
  const page = await browser.newPage();
  await page.setViewport(viewport);
  const complaints = [];
  page.on('console', message => {
    // Drivers' remarks on how quick reading pixels is are none of the page's.
    if (['error', 'warn'].includes(message.type()) && !message.text().includes('GPU stall')) complaints.push(message.text());
  });
  page.on('pageerror', error => complaints.push(String(error)));
  page.on('requestfailed', request => complaints.push(`${request.url()}: ${request.failure()?.errorText}`));
  await page.goto(where.startsWith('http') ? where : pathToFileURL(where).href);
  await page.waitForSelector('body[data-ready]', {timeout: 120000});
  return {page, complaints};
}
