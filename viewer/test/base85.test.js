import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decode, encode } from '../src/base85.js';

test('bytes are those of their text, for every length of the last group', () => {
  for (let length = 0; length < 300; length += 1) {
    const bytes = Uint8Array.from({ length }, (_, k) => (k * k * 7 + length * 31 + (k % 3 ? 0 : 255)) % 256);
    const text = encode(bytes);
    assert.equal(text.length, length + Math.ceil(length / 4));
    assert.match(text, /^[^"$&'/<\\{}\s]*$/);
    assert.deepEqual(decode(text), bytes);
  }
});

test('the smallest and the largest groups', () => {
  assert.equal(encode(Uint8Array.of(0, 0, 0, 0)), '!!!!!');
  for (const value of [0, 255]) {
    for (const length of [1, 2, 3, 4]) {
      const bytes = new Uint8Array(length).fill(value);
      assert.deepEqual(decode(encode(bytes)), bytes);
    }
  }
});
