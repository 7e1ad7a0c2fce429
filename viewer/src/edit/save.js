// Saves the scene, the path and the page itself as files.

const fileName = (title) => title.replace(/[^\p{L}\p{N}._-]+/gu, '_').replace(/^\.+/, '') || 'scene';

/** Hands a text to the reader as a file. */
export function saveFile(text, title, ending, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = `${fileName(title)}${ending}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// JSON that cannot end its script element.
const inert = (value) =>
  JSON.stringify(value).replace(/[<>&\u2028\u2029]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`);

/** The page as it was written, to be called before anything in it changes; the function returned fills in other data. */
export function rememberPage() {
  const root = document.documentElement.cloneNode(true);
  return (data) => {
    root.querySelector('#cdpr-data').textContent = inert(data);
    return `<!doctype html>\n${root.outerHTML}\n`;
  };
}
