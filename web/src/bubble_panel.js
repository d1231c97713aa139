// The picked bubble: its numbers now, and how they came about.
import {numberText} from './colours.js';
import {Plot} from './plot.js';
import {plotKeys} from './plot_keys.js';

const byId = id => document.getElementById(id);

const rows = [
  ['volume', bubble => (bubble.volume === null ? 'not closed' : `${numberText(bubble.volume)} L³`)],
  ['area', bubble => `${numberText(bubble.area)} L²`],
  ['pressure', bubble => (bubble.pressure === null ? 'not known' : `${numberText(bubble.pressure)} film tensions / L`)],
  ['faces', bubble => String(bubble.faces)],
];

export function bubblePanel(app) {
  const canvas = byId('history-plot');
  const plot = new Plot(canvas, {onSeek: time => app.seekTime(time), colour: '#9be28f'});
  plotKeys(canvas, app);
  const select = byId('bubble');
  select.addEventListener('change', () => app.pick(Number(select.value)));
  byId('bubble-before').addEventListener('click', () => app.pickNext(-1));
  byId('bubble-next').addEventListener('click', () => app.pickNext(1));
  let listed = '';

  function list(regions) {
    const text = regions.join();
    if (text === listed) return;
    listed = text;
    select.replaceChildren(new Option('none', '-1'), ...regions.map(region => new Option(`bubble ${region}`, String(region))));
  }

  function show() {
    const {picked} = app.view.look;
    const regions = [...app.frame.bubbles.keys()];
    if (picked >= 0 && !regions.includes(picked)) regions.push(picked);
    list(regions);
    select.value = String(picked);
    const bubble = app.frame.bubbles.get(picked);
    byId('bubble-hint').hidden = picked >= 0;
    byId('history-choice').hidden = canvas.hidden = picked < 0;
    const entries = bubble ? rows : picked < 0 ? [] : [['state', () => 'not there at this time']];
    byId('bubble-values').replaceChildren(...entries.flatMap(([name, text]) => {
      const term = document.createElement('dt'), value = document.createElement('dd');
      term.textContent = name;
      value.textContent = text(bubble);
      return [term, value];
    }));
    if (picked < 0) return;
    const quantity = byId('history').value;
    plot.set(quantity, app.run.history(picked, quantity), app.run.span);
    plot.setNow(app.frame.time, app.index, app.run.frames.length);
  }

  byId('history').addEventListener('change', show);
  return {show};
}
