// The page: what its controls do, and what they show of the run.
import {bubblePanel} from './bubble_panel.js';
import {colouring} from './colours.js';
import {listenToKeys} from './keys.js';
import {showLegend} from './legend.js';
import {metricsPanel} from './metrics_panel.js';
import {Run} from './run.js';
import {View} from './view.js';

const byId = id => document.getElementById(id);
const pollMilliseconds = 2000;

export class App {
  constructor(source, complain) {
    this.run = new Run(source);
    this.complain = complain;
    this.index = 0;
    this.playing = false;
  }

  async start() {
    await this.run.describe();
    this.view = new View(byId('view'));
    this.bubble = bubblePanel(this);
    this.metrics = metricsPanel(this);
    this.#listen();
    listenToKeys(this);
    this.#describe();
    await this.seek(0);
    this.#fillColours();
    this.#chooseColour('glass');
    document.body.dataset.ready = 'true';
    if (this.run.running) this.#poll();
  }

  #describe() {
    const {description, frames} = this.run;
    byId('scene').textContent = description.scene;
    byId('scene').title = description.command;
    byId('state').textContent = this.run.running ? 'running' : description.ended;
    byId('state').classList.toggle('running', this.run.running);
    byId('time').max = String(frames.length - 1);
    this.metrics.fill();
  }

  // While the run goes on; the last frame stays the last one.
  async #poll() {
    await new Promise(resolve => setTimeout(resolve, pollMilliseconds));
    try {
      const atEnd = this.index === this.run.frames.length - 1;
      await this.run.describe();
      this.#describe();
      if (atEnd && !this.playing) await this.seek(this.run.frames.length - 1);
    } catch (error) {
      byId('state').textContent = 'the server has ended';
      byId('state').classList.remove('running');
      return;
    }
    if (this.run.running) this.#poll();
  }

  #listen() {
    const view = changes => this.view.setLook(changes);
    const on = (id, event, act) => byId(id).addEventListener(event, act);
    const slider = (id, act, text) => {
      const show = () => {
        byId(`${id}-value`).textContent = text(Number(byId(id).value));
        act(Number(byId(id).value));
      };
      on(id, 'input', show);
      show();
    };
    const percent = value => `${Math.round(100 * value)}%`;
    slider('opacity', opacity => view({opacity}), percent);
    slider('cut', cutAt => view({cutAt}), percent);
    slider('explode', explode => view({explode}), percent);
    on('colour', 'change', event => this.#chooseColour(event.target.value));
    on('borders', 'change', event => view({borders: event.target.checked}));
    on('cut-axis', 'change', event => view({cut: event.target.value || null}));
    on('fit', 'click', () => this.view.fit());
    on('help-open', 'click', () => byId('help').showModal());
    on('play', 'click', () => this.play(!this.playing));
    on('time', 'input', event => {
      this.play(false);
      this.seek(Number(event.target.value));
    });
    on('panel-toggle', 'click', () => {
      const hidden = document.body.classList.toggle('narrow-panel');
      byId('panel-toggle').setAttribute('aria-expanded', String(!hidden));
    });
    this.#listenToPicks();
  }

  #listenToPicks() {
    const canvas = byId('view');
    let pressed = null;
    canvas.addEventListener('pointerdown', event => {
      pressed = event.isPrimary ? [event.clientX, event.clientY] : null;
    });
    canvas.addEventListener('pointerup', event => {
      if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 6) return;
      const box = canvas.getBoundingClientRect();
      this.pickAt(event.clientX - box.left, event.clientY - box.top);
    });
  }

  // The nearest bubble there; the next one behind it when that is picked already.
  pickAt(x, y) {
    const bubbles = [...new Set(this.view.hits(x, y).map(hit => hit.bubble).filter(bubble => bubble > 0))];
    const at = bubbles.indexOf(this.view.look.picked);
    this.pick(bubbles.length === 0 ? -1 : bubbles[(at + 1) % bubbles.length]);
  }

  pick(region) {
    this.view.setLook({picked: region});
    this.bubble.show();
    byId('announce').textContent = region < 0 ? 'no bubble' : `bubble ${region}`;
  }

  pickNext(by) {
    const regions = [...this.frame.bubbles.keys()];
    if (regions.length === 0) return;
    const at = regions.indexOf(this.view.look.picked);
    this.pick(regions[at < 0 ? 0 : (at + by + regions.length) % regions.length]);
  }

  #fillColours() {
    const select = byId('colour');
    const options = [['glass', 'iridescent glass'], ['bubbles', 'bubbles'], ...[...this.frame.fields.keys()].map(name => [`field/${name}`, name.replaceAll('_', ' ')])];
    select.replaceChildren(...options.map(([value, text]) => new Option(text, value)));
  }

  #chooseColour(name) {
    byId('colour').value = name;
    const field = name.startsWith('field/') ? name.slice('field/'.length) : null;
    this.view.setLook({glass: name === 'glass', byBubble: name === 'bubbles', field: field && {name: field, ...colouring(this.run.rangesOf(field))}});
    showLegend(this.view.look.field);
  }

  nextColour() {
    const select = byId('colour');
    this.#chooseColour(select.options[(select.selectedIndex + 1) % select.options.length].value);
  }

  async seek(index) {
    const wanted = Math.min(this.run.frames.length - 1, Math.max(0, index));
    this.index = wanted;
    let frame;
    try {
      frame = await this.run.frame(wanted);
    } catch (error) {
      this.play(false);
      this.complain(error);
      return;
    }
    if (this.index !== wanted) return;
    this.frame = frame;
    const {field} = this.view.look;
    if (field) this.view.look.field = {name: field.name, ...colouring(this.run.rangesOf(field.name))};
    this.view.show(frame);
    showLegend(this.view.look.field);
    const {frames} = this.run;
    byId('time').value = String(wanted);
    byId('time').setAttribute('aria-valuetext', `frame ${wanted + 1} of ${frames.length}, time ${frame.time}`);
    byId('clock').textContent = `t = ${Number(frame.time.toPrecision(6))} · step ${frame.step} · ${wanted + 1}/${frames.length}`;
    this.bubble.show();
    this.metrics.showNow();
    if (wanted + 1 < frames.length) this.run.frame(wanted + 1).catch(() => {});
  }

  seekTime(time) {
    const {frames} = this.run;
    let best = 0;
    frames.forEach((frame, i) => {
      if (Math.abs(frame.time - time) < Math.abs(frames[best].time - time)) best = i;
    });
    this.play(false);
    return this.seek(best);
  }

  play(on) {
    if (on === this.playing) return;
    this.playing = on;
    byId('play').textContent = on ? '❚❚' : '▶';
    byId('play').setAttribute('aria-label', on ? 'Pause' : 'Play');
    if (on) this.#playOn();
  }

  async #playOn() {
    if (this.index === this.run.frames.length - 1) await this.seek(0);
    while (this.playing) {
      const begin = performance.now();
      await new Promise(requestAnimationFrame);
      const last = this.index === this.run.frames.length - 1;
      if (last && !byId('loop').checked) {
        this.play(false);
        return;
      }
      await this.seek(last ? 0 : this.index + 1);
      const rest = 1000 / Number(byId('speed').value) - (performance.now() - begin);
      if (rest > 0) await new Promise(resolve => setTimeout(resolve, rest));
    }
  }
}
