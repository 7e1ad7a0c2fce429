// Bytes as text within a page, 4 bytes in 5 characters: 6 % shorter than base64. The digits are the printable characters of ASCII
// in their order, without those that mean something in HTML, in text of JavaScript or in the placeholders of the page.

const DIGITS = Array.from({ length: 94 }, (_, k) => String.fromCharCode(33 + k)).filter((c) => !'"$&\'/<\\{}'.includes(c)).join('');

/** Bytes as text. Of the last bytes, n give n + 1 characters. */
export function encode(bytes) {
  const parts = [];
  for (let from = 0; from < bytes.length; from += 4) {
    let value = 0;
    for (let k = 0; k < 4; k += 1) value = 256 * value + (bytes[from + k] ?? 0);
    const digits = Array(5);
    for (let k = 4; k >= 0; k -= 1) {
      digits[k] = DIGITS[value % 85];
      value = Math.floor(value / 85);
    }
    parts.push(digits.slice(0, Math.min(5, bytes.length - from + 1)).join(''));
  }
  return parts.join('');
}

/** The bytes of a text made by `encode`. */
export function decode(text) {
  const values = new Uint8Array(128);
  for (let k = 0; k < 85; k += 1) values[DIGITS.charCodeAt(k)] = k;
  const length = Math.floor((4 * text.length) / 5);
  const bytes = new Uint8Array(length);
  for (let from = 0, at = 0; from < text.length; from += 5, at += 4) {
    let value = 0;
    for (let k = 0; k < 5; k += 1) value = 85 * value + (from + k < text.length ? values[text.charCodeAt(from + k)] : 84);
    for (let k = 3; k >= 0; k -= 1) {
      if (at + k < length) bytes[at + k] = value % 256;
      value = Math.floor(value / 256);
    }
  }
  return bytes;
}
