import {App} from './app.js';
import {runSource} from './source.js';

const message = document.getElementById('message');

function complain(error) {
  message.textContent = error.message || String(error);
  message.hidden = false;
}

function canDraw() {
  try {
    return Boolean(document.createElement('canvas').getContext('webgl2'));
  } catch {
    return false;
  }
}

if (!canDraw()) {
  complain(new Error('This browser cannot draw in three dimensions (WebGL 2 is not available or is switched off).'));
} else {
  const app = new App(runSource(), complain);
  // For scripts: what is shown, and how to change it.
  window.foamsim = app;
  app.start().catch(complain);
}
