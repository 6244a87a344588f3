// SPDX-License-Identifier: MIT
// A page in a real browser, which must never make requests or report errors.
import { chromium } from "playwright-core";

const flags = [
  "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
  "--disable-sync", "--enable-unsafe-swiftshader", "--use-gl=angle", "--use-angle=swiftshader",
];

/** In the page: keeps the moment that it opens at, which a page that plays leaves at once. */
function noteOpening() {
  const look = () => (window.trophic ? (window.openedAt = window.trophic.time) : requestAnimationFrame(look));
  requestAnimationFrame(look);
}

/** How long a condition may take on a busy machine. */
export const patience = { timeout: 120000 };

export class Browser {
  static async start() {
    const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: flags });
    return new Browser(browser, await browser.newContext({ viewport: { width: 1280, height: 800 } }));
  }

  /** The same browser with other windows: `options` as playwright has them. */
  async with(options) {
    return new Browser(this.browser, await this.browser.newContext(options));
  }

  constructor(browser, context) {
    this.browser = browser;
    this.context = context;
  }

  /** Opens a file and waits until it shows what it was asked for. Without a moment in its link a page plays a catch. */
  async open(file, hash = "#t=0") {
    const opened = await this.openAt(`file://${file}`, hash);
    await opened.settle();
    return opened;
  }

  /** Opens an address. `prepare` is called in the page before its own code. */
  async openAt(address, hash = "", prepare = () => undefined) {
    const page = await this.context.newPage();
    const opened = new OpenedPage(page, address);
    page.setDefaultTimeout(patience.timeout);
    await page.addInitScript(noteOpening);
    await page.addInitScript(prepare);
    opened.session = await this.context.newCDPSession(page);
    await opened.session.send("Performance.enable", { timeDomain: "threadTicks" });
    await page.goto(address + hash);
    return opened;
  }

  async close() {
    await this.browser.close();
  }
}

export class OpenedPage {
  complaints = [];
  requests = [];

  constructor(page, url) {
    this.page = page;
    page.on("pageerror", (error) => this.complaints.push(error.message));
    page.on("console", (message) => {
      if (["error", "assert"].includes(message.type())) this.complaints.push(message.text());
    });
    page.on("request", (request) => {
      if (!/^(data|blob):/.test(request.url()) && request.url() !== url) this.requests.push(request.url());
    });
  }

  /** Waits until the page shows what it was asked for. */
  async settle() {
    await this.page.waitForFunction(() => window.trophicError || window.trophic?.settled, null, patience);
  }

  /** Shows a moment, with an individual selected if one is given. */
  async seek(time, id) {
    await this.evaluate(([moment, one]) => {
      window.trophic.seek(moment);
      if (one !== undefined) window.trophic.select(one);
    }, [time, id]);
    await this.settle();
  }

  /** The rows of the inspector: term, text. */
  async inspected() {
    return Object.fromEntries(await this.page.$$eval(".inspector dt", (terms) => terms.map((term) => [term.textContent, term.nextSibling.textContent])));
  }

  /** Waits until a condition of the page holds. */
  until(condition, argument = null) {
    return this.page.waitForFunction(condition, argument, patience);
  }

  /** Waits until the number of pixels near a colour is as wanted: a world is drawn some frames after its page. */
  async untilPixels(colour, isWanted) {
    const end = Date.now() + patience.timeout;
    for (let found = await this.pixels(colour); !isWanted(found); found = await this.pixels(colour)) {
      if (Date.now() > end) throw new Error(`${found} pixels near ${colour}`);
      await this.page.waitForTimeout(50);
    }
  }

  /** Processor seconds of the page's own thread until now. */
  async busySeconds() {
    const { metrics } = await this.session.send("Performance.getMetrics");
    return metrics.find((metric) => metric.name === "TaskDuration").value;
  }

  /** Rows that the controls take. */
  rowsOfControls() {
    return this.page.$$eval(".controls > *", (ones) => {
      const shown = ones.filter((one) => one.offsetHeight > 0 && one.className !== "space");
      const middles = shown.map((one) => one.offsetTop + one.offsetHeight / 2).sort((a, b) => a - b);
      return middles.filter((at, i) => i === 0 || at - middles[i - 1] > 12).length;
    });
  }

  evaluate(work, argument) {
    return this.page.evaluate(work, argument);
  }

  /** Number of pixels of a run's world near a colour "#rrggbb", now or in a picture of it that was kept. */
  pixels(colour, world = 0, kept = undefined) {
    return this.page.evaluate(
      async ([wanted, number, before]) => {
        const picture = new Image();
        picture.src = before ?? window.trophic.worlds[number].picture();
        await picture.decode();
        const canvas = new OffscreenCanvas(picture.width, picture.height);
        const g = canvas.getContext("2d");
        g.drawImage(picture, 0, 0);
        const { data } = g.getImageData(0, 0, picture.width, picture.height);
        const [r, gr, b] = [1, 3, 5].map((at) => parseInt(wanted.slice(at, at + 2), 16));
        let count = 0;
        for (let i = 0; i < data.length; i += 4) {
          if (Math.abs(data[i] - r) + Math.abs(data[i + 1] - gr) + Math.abs(data[i + 2] - b) < 60) ++count;
        }
        return count;
      },
      [colour, world, kept],
    );
  }

  /** Clicks at a place of an element, CSS pixels from its corner. */
  async click(selector, x, y) {
    const bounds = await this.page.locator(selector).first().boundingBox();
    await this.page.mouse.click(bounds.x + x, bounds.y + y);
    await this.frames();
    await this.settle();
  }

  /** Waits for two frames: a busy page has then taken its input and its new sizes. */
  frames() {
    return this.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }
}
