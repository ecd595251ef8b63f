import { chromium } from 'playwright-core';
const [base, out, w = '1440', h = '900', machine = 'mill', scheme = 'dark', ...rest] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--disable-gpu-rasterization', '--disable-accelerated-2d-canvas'] });
const page = await browser.newPage({ viewport: { width: +w, height: +h }, colorScheme: scheme, locale: rest.includes('zh') ? 'zh-TW' : 'en-US' });
page.on('console', (m) => ['error', 'warning'].includes(m.type()) && console.log(m.type(), m.text()));
page.on('pageerror', (e) => console.log('PAGEERROR', e.message, e.stack?.split('\n').slice(0, 3).join('|')));
await page.addInitScript((m) => sessionStorage.setItem('kerf.machine', m), machine);
await page.goto(base); await page.waitForTimeout(2500);
for (const r of rest) { if (r.startsWith('js:')) { await page.evaluate(r.slice(3)); await page.waitForTimeout(300); } if (r.startsWith('click:')) { await page.locator(r.slice(6)).first().click(); await page.waitForTimeout(400); } if (r.startsWith('key:')) { await page.keyboard.press(r.slice(4)); await page.waitForTimeout(400); } if (r.startsWith('wait:')) await page.waitForTimeout(+r.slice(5)); }
await page.screenshot({ path: out });
await browser.close();
