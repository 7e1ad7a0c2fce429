// A printed page: the picture as it is seen, in the light look, then result, charts and table.

/** Puts the picture into the page while it is printed; `picture` draws it, `setPrinting` makes it light. */
export function connectPrinting(picture, margins, setPrinting) {
  const place = document.getElementById('print-picture');
  window.addEventListener('beforeprint', () => {
    setPrinting(true);
    place.replaceChildren(cropped(picture(), margins()));
  });
  window.addEventListener('afterprint', () => {
    setPrinting(false);
    place.replaceChildren();
  });
}

// The part of the picture that no panel covers.
function cropped(source, { left, right, top, bottom }) {
  const ratio = source.width / window.innerWidth;
  const copy = document.createElement('canvas');
  copy.width = Math.max(1, source.width - (left + right) * ratio);
  copy.height = Math.max(1, source.height - (top + bottom) * ratio);
  copy.getContext('2d').drawImage(source, -left * ratio, -top * ratio);
  return copy;
}
