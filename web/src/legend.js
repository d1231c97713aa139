// The scale of a field's colours beside the view.
import {colourMaps, numberText} from './colours.js';

const units = {mean_curvature: '1/L', pressure_jump: 'film tensions / L', circulation: 'L²/T'};

export function showLegend(field) {
  const box = document.getElementById('legend');
  box.hidden = !field;
  if (!field) return;
  const unit = units[field.name];
  const title = field.name.replaceAll('_', ' ') + (unit ? ` (${unit})` : '');
  document.getElementById('legend-title').textContent = title;
  const bar = document.getElementById('legend-bar');
  const g = bar.getContext('2d');
  const colours = colourMaps[field.map];
  for (let i = 0; i < bar.height; ++i) {
    const at = 4 * Math.round(255 * (1 - i / (bar.height - 1)));
    g.fillStyle = `rgb(${colours[at]}, ${colours[at + 1]}, ${colours[at + 2]})`;
    g.fillRect(0, i, bar.width, 1);
  }
  const values = [4, 3, 2, 1, 0].map(i => field.low + (i / 4) * (field.high - field.low));
  document.getElementById('legend-ticks').replaceChildren(...values.map(value => {
    const item = document.createElement('li');
    item.textContent = numberText(Math.abs(value) < 1e-12 * (field.high - field.low) ? 0 : value);
    return item;
  }));
  box.setAttribute('aria-label', `Colours of ${title}, from ${numberText(field.low)} to ${numberText(field.high)}`);
}
