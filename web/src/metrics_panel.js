// Two of the run's metrics against time.
import {Plot} from './plot.js';
import {plotKeys} from './plot_keys.js';

const byId = id => document.getElementById(id);
const usual = {metric: ['energy', 'area', 'triangles'], 'metric-2': ['volume_drift_max', 'area', 'triangles']};

export function metricsPanel(app) {
  const plots = Object.keys(usual).map(id => {
    const canvas = byId(`${id}-plot`), select = byId(id);
    const plot = new Plot(canvas, {onSeek: time => app.seekTime(time)});
    plotKeys(canvas, app);
    select.addEventListener('change', () => draw());
    return {id, plot, select};
  });

  function draw() {
    const events = app.run.description.events.map(event => event.time);
    for (const {plot, select} of plots) plot.set(select.value.replaceAll('_', ' '), app.run.metric(select.value), app.run.span, events);
    showNow();
  }

  function showNow() {
    if (!app.frame) return;
    for (const {plot} of plots) plot.setNow(app.frame.time, app.index, app.run.frames.length);
  }

  function fill() {
    const names = Object.keys(app.run.description.metrics).filter(name => name !== 'step' && name !== 'time');
    for (const {id, select} of plots) {
      const before = select.value || usual[id].find(name => names.includes(name)) || names[0];
      select.replaceChildren(...names.map(name => new Option(name.replaceAll('_', ' '), name)));
      if (before) select.value = before;
    }
    draw();
  }

  return {fill, showNow};
}
