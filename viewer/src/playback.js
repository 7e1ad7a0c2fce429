// The position along the path: slider, play and pause.

// Time to play the whole path, s.
const DURATION = 8;
const LONGEST_STEP = 0.1;

/** A distance between 0 and a length that can run by itself; `onMove` and `onState` hear of changes. */
export function createPlayback(whole, onMove, onState) {
  let length = whole;
  let distance = 0;
  let playing = false;
  let before = 0;
  let speed = 1;

  function setDistance(value) {
    const wanted = Number.isFinite(value) ? value : 0;
    distance = Math.min(length, Math.max(0, wanted));
    onMove(distance);
  }

  function setPlaying(value) {
    if (value === playing) return;
    playing = value;
    onState(playing);
    if (playing) begin();
  }

  function begin() {
    if (distance >= length) setDistance(0);
    before = performance.now();
    requestAnimationFrame(advance);
  }

  function advance(now) {
    if (!playing) return;
    const seconds = Math.min(LONGEST_STEP, Math.max(0, (now - before) / 1000));
    before = now;
    setDistance(distance + (speed * seconds * length) / DURATION);
    if (distance >= length) setPlaying(false);
    else requestAnimationFrame(advance);
  }

  return {
    length: () => length,
    /** Begins another path of this length, m. */
    restart: (value) => {
      setPlaying(false);
      length = value;
      setDistance(0);
    },
    distance: () => distance,
    setDistance,
    setSpeed: (value) => {
      speed = value;
    },
    pause: () => setPlaying(false),
    toggle: () => setPlaying(length > 0 && !playing),
  };
}
