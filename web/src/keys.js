// Keys of the whole page; fields that take keys of their own keep them.

const byId = id => document.getElementById(id);

function press(id) {
  byId(id).dispatchEvent(new Event('change', {bubbles: true}));
}

function nextOption(id) {
  const select = byId(id);
  select.selectedIndex = (select.selectedIndex + 1) % select.options.length;
  press(id);
}

function explode() {
  const slider = byId('explode');
  slider.value = Number(slider.value) > 0 ? '0' : '0.6';
  slider.dispatchEvent(new Event('input', {bubbles: true}));
}

export function listenToKeys(app) {
  const turn = 0.12;
  const step = by => {
    app.play(false);
    app.seek(app.index + by);
  };
  const keys = {
    ' ': () => app.play(!app.playing),
    ArrowLeft: () => step(-1),
    ArrowRight: () => step(1),
    Home: () => step(-app.index),
    End: () => step(app.run.frames.length),
    '+': () => app.view.zoom(0.9),
    '=': () => app.view.zoom(0.9),
    '-': () => app.view.zoom(1 / 0.9),
    f: () => app.view.fit(),
    m: () => app.nextColour(),
    b: () => byId('borders').click(),
    c: () => nextOption('cut-axis'),
    e: explode,
    '[': () => app.pickNext(-1),
    ']': () => app.pickNext(1),
    Escape: () => app.pick(-1),
    '?': () => byId('help').showModal(),
  };
  const turns = {ArrowLeft: [-turn, 0], ArrowRight: [turn, 0], ArrowUp: [0, turn], ArrowDown: [0, -turn]};
  document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey || byId('help').open) return;
    const {target} = event;
    const own = target.matches('select, input, button, [role=slider]');
    const takes = own && (event.key === ' ' || event.key === 'Enter' || event.key.startsWith('Arrow') || event.key === 'Home' || event.key === 'End' || target.matches('select'));
    if (takes) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    let act = event.shiftKey && turns[key] ? () => app.view.turn(...turns[key]) : keys[key];
    if (key === 'Enter' && target.id === 'view') act = () => app.pickAt(target.clientWidth / 2, target.clientHeight / 2);
    if (!act) return;
    event.preventDefault();
    act();
  });
}
