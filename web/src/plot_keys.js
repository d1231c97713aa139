// A plot that has the focus is a slider of the time.
export function plotKeys(canvas, app) {
  canvas.addEventListener('keydown', event => {
    const to = {ArrowLeft: app.index - 1, ArrowRight: app.index + 1, Home: 0, End: app.run.frames.length - 1}[event.key];
    if (to === undefined || event.shiftKey) return;
    event.preventDefault();
    event.stopPropagation();
    app.play(false);
    app.seek(to);
  });
}
