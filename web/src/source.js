// Where a run's data comes from: elements of the page (export-web) or the server that sent it (view). Both have
// describe(), the run's description, and frame(step), the bytes of a packed frame.

async function unzip(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

class EmbeddedSource {
  live = false;

  async #bytes(name) {
    const element = document.querySelector(`script[data-name="${name}"]`);
    if (!element) throw new Error(`this file holds no ${name}`);
    return unzip(bytesOfBase64(element.textContent));
  }

  async describe() {
    return JSON.parse(new TextDecoder().decode(await this.#bytes('run')));
  }

  frame(step) {
    return this.#bytes(`frame/${step}`);
  }
}

class LiveSource {
  live = true;

  async #get(path) {
    const answer = await fetch(path, {cache: 'no-store', credentials: 'omit'});
    if (!answer.ok) throw new Error((await answer.text()).trim() || `the server answers ${answer.status}`);
    return answer;
  }

  async describe() {
    return (await this.#get('run.json')).json();
  }

  async frame(step) {
    return unzip(await (await this.#get(`frame/${step}`)).arrayBuffer());
  }
}

export function runSource() {
  return document.querySelector('meta[name="foamsim-live"]') ? new LiveSource() : new EmbeddedSource();
}
