// What a page carries: a JSON object that says what there is, and arrays packed into one gzip
// stream. Writer: app/page_data.cpp.

function bytesOfBase64(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

async function unpacked(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Integers lie byte by byte: first all lowest bytes, then all second ones, and so on.
function joinPlanes(bytes, at, count, planes) {
  const numbers = new Uint32Array(count);
  for (let k = 0; k < planes; ++k) {
    const from = at + k * count;
    const shift = 8 * k;
    for (let i = 0; i < count; ++i) numbers[i] |= bytes[from + i] << shift;
  }
  return numbers;
}

// 0, 1, 2, 3 ... stand for 0, -1, 1, -2 ...
function unfold(numbers) {
  const signed = new Int32Array(numbers.buffer);
  for (let i = 0; i < signed.length; ++i) signed[i] = (numbers[i] >>> 1) ^ -(numbers[i] & 1);
  return signed;
}

export class PageData {
  constructor(about, bytes) {
    this.about = about;
    this.bytes = bytes;
    this.entries = new Map(about.arrays.map((entry) => [entry.name, entry]));
  }

  has(name) {
    return this.entries.has(name);
  }

  array(name) {
    const { kind, at, count, planes } = this.entries.get(name);
    if (kind === 'unsigned') return joinPlanes(this.bytes, at, count, planes);
    if (kind === 'signed') return unfold(joinPlanes(this.bytes, at, count, planes));
    if (kind === 'text') return new TextDecoder().decode(this.bytes.subarray(at, at + count));
    // Copied, because a typed array must begin at a multiple of its width.
    const copy = this.bytes.slice(at, at + count * planes).buffer;
    return kind === 'float' ? new Float32Array(copy) : new Float64Array(copy);
  }
}

export async function loadPage(document) {
  const about = JSON.parse(document.getElementById('about').textContent);
  const element = document.getElementById('data');
  let bytes;
  try {
    bytes = await unpacked(bytesOfBase64(element.textContent.trim()));
  } catch (cause) { // in the browser's words a letter that is none, or a fetch that failed
    throw new Error('its data are broken or cut off', { cause });
  }
  element.remove();
  return new PageData(about, bytes);
}
