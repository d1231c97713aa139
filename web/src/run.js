// A run as the page shows it: its description, frames that are read when they are wanted and kept while there is room, and
// what has been learnt of bubbles and ranges of fields.
import {bubblesOf, unpackFrame} from './frame.js';

const room = 400e6;

export class Run {
  constructor(source) {
    this.source = source;
    this.kept = new Map();
    this.keptBytes = 0;
    this.loading = new Map();
    this.bubbles = new Map();
    this.ranges = new Map();
  }

  get running() {
    return this.source.live && this.description.ended === 'running';
  }

  get frames() {
    return this.description.frames;
  }

  async describe() {
    this.description = await this.source.describe();
    for (const [step, list] of Object.entries(this.description.bubbles)) this.bubbles.set(Number(step), bubblesOf(list));
  }

  frame(index) {
    const {step} = this.frames[index];
    const known = this.kept.get(step);
    if (known) {
      this.kept.delete(step);
      this.kept.set(step, known);
      return Promise.resolve(known);
    }
    if (!this.loading.has(step)) {
      const loaded = this.source.frame(step).then(bytes => this.#keep(step, unpackFrame(bytes)));
      this.loading.set(step, loaded.finally(() => this.loading.delete(step)));
    }
    return this.loading.get(step);
  }

  #keep(step, frame) {
    this.kept.set(step, frame);
    this.keptBytes += frame.bytes;
    for (const [old, oldFrame] of this.kept) {
      if (this.keptBytes <= room || old === step) break;
      this.kept.delete(old);
      this.keptBytes -= oldFrame.bytes;
    }
    this.bubbles.set(step, frame.bubbles);
    for (const [name, field] of frame.fields) {
      if (!this.ranges.has(name)) this.ranges.set(name, new Map());
      this.ranges.get(name).set(step, field.usual);
    }
    return frame;
  }

  rangesOf(name) {
    return [...(this.ranges.get(name)?.values() ?? [])];
  }

  timeOfStep(step) {
    const {frames} = this;
    let i = frames.findIndex(frame => frame.step >= step);
    if (i < 0) i = frames.length - 1;
    if (i === 0 || frames[i].step === step) return frames[i].time;
    const [a, b] = [frames[i - 1], frames[i]];
    return a.time + ((step - a.step) / (b.step - a.step)) * (b.time - a.time);
  }

  // [time, value] of a bubble: of frames that are known, volumes of the run's table.
  history(region, quantity) {
    const {volumes} = this.description;
    if (quantity === 'volume' && volumes.volumes[region])
      return volumes.steps.map((step, i) => [this.timeOfStep(step), volumes.volumes[region][i] ?? NaN]);
    return this.frames.flatMap(({step, time}) => {
      const bubble = this.bubbles.get(step)?.get(region);
      return bubble ? [[time, bubble[quantity] ?? NaN]] : [];
    });
  }

  metric(name) {
    const {metrics} = this.description;
    const values = metrics[name];
    if (!values) return [];
    return values.map((value, i) => [metrics.time ? metrics.time[i] : i, value ?? NaN]);
  }

  get span() {
    const {frames} = this;
    return [frames[0].time, frames[frames.length - 1].time];
  }
}
