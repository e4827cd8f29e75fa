// Drives headless Chromium over its debugging pipe, with Node alone. What a page says on its console, and any error in
// it, is kept.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export class Browser {
  static async start(program, ...flags) {
    const browser = new Browser();
    browser.profile = mkdtempSync(join(tmpdir(), 'restrip-chromium-'));
    browser.process = spawn(program, ['--headless', '--no-sandbox', '--remote-debugging-pipe', `--user-data-dir=${browser.profile}`,
      '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
      '--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage', '--hide-scrollbars',
      '--force-device-scale-factor=1', ...flags, 'about:blank'], { stdio: ['ignore', 'ignore', 'pipe', 'pipe', 'pipe'] });
    browser.stderr = '';
    browser.process.stderr.on('data', (data) => { browser.stderr = (browser.stderr + data).slice(-20000); });
    browser.ended = new Promise((resolve) => browser.process.on('exit', resolve));
    browser.calls = new Map();
    browser.listeners = [];
    browser.next = 0;
    let rest = Buffer.alloc(0);
    browser.process.stdio[4].on('data', (data) => {
      rest = Buffer.concat([rest, data]);
      for (let end; (end = rest.indexOf(0)) >= 0; rest = rest.subarray(end + 1)) browser.#received(JSON.parse(rest.subarray(0, end).toString()));
    });
    browser.process.on('exit', (code) => {
      for (const { reject } of browser.calls.values()) reject(new Error(`${program} ended with ${code}\n${browser.stderr}`));
    });
    return browser;
  }
  #received(message) {
    if (message.id === undefined) return this.listeners.forEach((listener) => listener(message));
    const { resolve, reject } = this.calls.get(message.id);
    this.calls.delete(message.id);
    if (message.error) reject(new Error(message.error.message));
    else resolve(message.result);
  }
  send(method, params = {}, sessionId = undefined) {
    const id = ++this.next;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.calls.set(id, { resolve, reject }));
  }
  async page(width, height, { dark = false, scripts = true, moves = false, sharp = 1 } = {}) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    const page = new Page(this, sessionId, targetId);
    await page.send('Page.enable');
    await page.send('Runtime.enable');
    await page.send('Log.enable');
    await page.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: sharp, mobile: false });
    await page.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' },
      { name: 'prefers-reduced-motion', value: moves ? 'no-preference' : 'reduce' }] });
    if (!scripts) await page.send('Emulation.setScriptExecutionDisabled', { value: true });
    return page;
  }
  async stop() {
    await Promise.race([this.send('Browser.close').catch(() => {}), new Promise((done) => setTimeout(done, 5000))]);
    await Promise.race([this.ended, new Promise((done) => setTimeout(done, 5000))]);
    this.process.kill('SIGKILL');
    await this.ended;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

class Page {
  /// What went wrong in the page, one sentence each.
  faults = [];

  constructor(browser, session, target) {
    this.browser = browser;
    this.session = session;
    this.target = target;
    browser.listeners.push(({ method, params, sessionId }) => {
      if (sessionId !== session) return;
      if (method === 'Runtime.exceptionThrown') this.faults.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
      if (method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(params.type))
        this.faults.push(params.args.map((a) => a.description ?? a.value).join(' '));
      if (method === 'Log.entryAdded' && ['error', 'warning'].includes(params.entry.level) && !/GPU stall/.test(params.entry.text))
        this.faults.push(params.entry.text);
    });
  }
  send(method, params) { return this.browser.send(method, params, this.session); }
  async open(url) {
    const loaded = new Promise((resolve) => this.browser.listeners.push(({ method, sessionId }) => {
      if (sessionId === this.session && method === 'Page.loadEventFired') resolve();
    }));
    const { errorText } = await this.send('Page.navigate', { url });
    if (errorText) throw new Error(`${url}: ${errorText}`);
    await loaded;
  }
  /// The value of an expression, or of a function called in the page.
  async run(code, ...values) {
    const expression = typeof code === 'function' ? `(${code})(...${JSON.stringify(values)})` : code;
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
  async until(code, ...values) {
    for (const end = Date.now() + 300000; Date.now() < end;) {
      if (await this.run(code, ...values)) return;
      await new Promise((done) => setTimeout(done, 50));
    }
    throw new Error(`never came true: ${code}; the page says: ${this.faults.join('; ')}`);
  }
  async screenshot() {
    return Buffer.from((await this.send('Page.captureScreenshot', { format: 'png' })).data, 'base64');
  }
}
