// A line plot on a canvas that is a slider of the time: click, drag or arrow keys seek.
import {numberText} from './colours.js';

const margin = {left: 8, right: 8, top: 24, bottom: 20};

export class Plot {
  constructor(canvas, {onSeek, colour = '#7cc9ff'}) {
    this.canvas = canvas;
    this.colour = colour;
    this.points = [];
    this.now = 0;
    this.events = [];
    const seek = event => {
      const box = canvas.getBoundingClientRect();
      const share = (event.clientX - box.left - margin.left) / (box.width - margin.left - margin.right);
      if (this.span) onSeek(this.span[0] + Math.min(1, Math.max(0, share)) * (this.span[1] - this.span[0]));
    };
    canvas.addEventListener('pointerdown', event => {
      canvas.setPointerCapture(event.pointerId);
      seek(event);
    });
    canvas.addEventListener('pointermove', event => {
      if (canvas.hasPointerCapture(event.pointerId)) seek(event);
    });
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  // `points`: [time, value], ascending; `span`: the times shown.
  set(title, points, span, events = []) {
    Object.assign(this, {title, points: points.filter(([, value]) => Number.isFinite(value)), span, events});
    this.draw();
  }

  setNow(time, frame, frames) {
    this.now = time;
    const {canvas} = this;
    canvas.setAttribute('aria-valuemin', '0');
    canvas.setAttribute('aria-valuemax', String(Math.max(0, frames - 1)));
    canvas.setAttribute('aria-valuenow', String(frame));
    canvas.setAttribute('aria-valuetext', `time ${numberText(time)}, ${this.title ?? ''} ${numberText(this.valueAt(time))}`);
    this.draw();
  }

  valueAt(time) {
    let value = null;
    for (const [t, v] of this.points) {
      if (t > time + 1e-9 * Math.abs(time)) break;
      value = v;
    }
    return value;
  }

  draw() {
    const {canvas, points} = this;
    const width = canvas.clientWidth, height = canvas.clientHeight, ratio = window.devicePixelRatio || 1;
    if (width === 0) return;
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    const g = canvas.getContext('2d');
    g.scale(ratio, ratio);
    g.clearRect(0, 0, width, height);
    g.font = '12px system-ui, sans-serif';
    g.fillStyle = '#a9b8cf';
    if (points.length === 0 || !this.span) {
      g.fillText('nothing to plot', margin.left, height / 2);
      return;
    }
    const values = points.map(point => point[1]);
    let low = Math.min(...values), high = Math.max(...values);
    const [highest, lowest] = [high, low];
    const least = 1e-6 * Math.max(Math.abs(low), Math.abs(high)) || 1;
    if (high - low < least) [low, high] = [low - least, high + least];
    const [from, to] = this.span[1] > this.span[0] ? this.span : [this.span[0] - 1, this.span[0] + 1];
    const x = t => margin.left + ((t - from) / (to - from)) * (width - margin.left - margin.right);
    const y = v => height - margin.bottom - ((v - low) / (high - low)) * (height - margin.top - margin.bottom);
    g.strokeStyle = '#22304a';
    g.lineWidth = 1;
    g.beginPath();
    for (let i = 0; i <= 2; ++i) {
      const line = y(low + (i / 2) * (high - low));
      g.moveTo(margin.left, line);
      g.lineTo(width - margin.right, line);
    }
    g.stroke();
    g.fillStyle = '#e0808a';
    for (const time of this.events) g.fillRect(x(time) - 0.75, height - margin.bottom, 1.5, 5);
    g.strokeStyle = this.colour;
    g.lineWidth = 1.75;
    g.beginPath();
    points.forEach(([t, v], i) => (i === 0 ? g.moveTo(x(t), y(v)) : g.lineTo(x(t), y(v))));
    g.stroke();
    const value = this.valueAt(this.now);
    g.strokeStyle = 'rgba(255,212,121,.75)';
    g.beginPath();
    g.moveTo(x(this.now), margin.top - 4);
    g.lineTo(x(this.now), height - margin.bottom);
    g.stroke();
    if (value !== null) {
      g.fillStyle = '#ffd479';
      g.beginPath();
      g.arc(x(this.now), y(value), 3.5, 0, 7);
      g.fill();
      g.fillText(numberText(value), margin.left, 15);
    }
    g.fillStyle = '#a9b8cf';
    g.textAlign = 'right';
    g.fillText(`${numberText(lowest)} to ${numberText(highest)}`, width - margin.right, 15);
    g.fillText(numberText(to), width - margin.right, height - 5);
    g.textAlign = 'left';
    g.fillText(numberText(from), margin.left, height - 5);
  }
}
