// Colour maps of 256 colours, from a few given ones. Sequential: viridis; diverging around 0: blue, pale, orange. Both keep
// their order for colour-blind eyes.

const viridis = ['#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b', '#fde725'];
const diverging = ['#2166d8', '#4f8fe6', '#8fbaf0', '#c9def5', '#f2f2f0', '#fbd9b0', '#f7b069', '#e88432', '#c75a0c'];

const channels = colour => [1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16));

function between(colours) {
  const bytes = new Uint8Array(256 * 4);
  const stops = colours.map(channels);
  for (let i = 0; i < 256; ++i) {
    const at = (i / 255) * (stops.length - 1), low = Math.min(Math.floor(at), stops.length - 2);
    for (let k = 0; k < 3; ++k) bytes[4 * i + k] = stops[low][k] + (at - low) * (stops[low + 1][k] - stops[low][k]);
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}

export const colourMaps = {sequential: between(viridis), diverging: between(diverging)};

// The range that is coloured, and by which map: symmetric where values of both signs are usual.
export function colouring(ranges) {
  const known = ranges.filter(([low, high]) => low !== null && high !== null);
  if (known.length === 0) return {low: 0, high: 1, map: 'sequential'};
  let low = Math.min(...known.map(range => range[0])), high = Math.max(...known.map(range => range[1]));
  if (low < 0 && high > 0 && Math.min(-low, high) > 0.02 * Math.max(-low, high)) {
    high = Math.max(-low, high);
    return {low: -high, high, map: 'diverging'};
  }
  // Rounding alone is no spread.
  const least = 1e-9 * Math.max(Math.abs(low), Math.abs(high), 1e-300);
  if (!(high - low > least)) [low, high] = low === 0 ? [0, 1] : [low - Math.abs(low) / 10, low + Math.abs(low) / 10];
  return {low, high, map: 'sequential'};
}

export function numberText(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(2) : String(Number(value.toPrecision(4)));
}
