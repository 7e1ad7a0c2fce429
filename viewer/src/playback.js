// The position along the path, or the time in a trajectory: slider, play and pause.

// Time to play the whole of a path, s.
const DURATION = 8;

/**
 * A distance between 0 and a length that can run by itself; `onMove` and `onState` hear of changes. For a trajectory it
 * is a time, which runs in real time: however few pictures are drawn, each shows where the platform is by then.
 */
export function createPlayback(whole, timed, onMove, onState, signal) {
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

  // By the clock: where pictures are slow, the time of a frame is behind it.
  function advance() {
    if (!playing) return;
    const now = performance.now();
    const seconds = Math.max(0, (now - before) / 1000);
    before = Math.max(before, now);
    setDistance(distance + speed * seconds * (timed ? 1 : length / DURATION));
    if (distance >= length) setPlaying(false);
    else requestAnimationFrame(advance);
  }

  // A hidden page draws nothing; it goes on where it stopped.
  document.addEventListener('visibilitychange', () => {
    before = performance.now();
  }, { signal });
  signal?.addEventListener('abort', () => {
    playing = false;
  });

  return {
    length: () => length,
    /** Begins another path of this length, m. */
    restart: (value) => {
      setPlaying(false);
      length = value;
      setDistance(0);
    },
    distance: () => distance,
    playing: () => playing,
    setDistance,
    setSpeed: (value) => {
      speed = value;
    },
    pause: () => setPlaying(false),
    toggle: () => setPlaying(length > 0 && !playing),
  };
}
