// Colours of the light and the dark look, after the Okabe–Ito palette.

// Cables and their regions have up to nine colours at once: the palettes "muted" (its pale colours darker, to be seen as
// thin lines) and "light" of Paul Tol, which colour-blind readers can tell apart, too.
const MUTED = ['#332288', '#2f8f80', '#aa4499', '#117733', '#cc6677', '#3a9bc4', '#882255', '#8a8a1f', '#b58e1c'];
const PALE = ['#77aadd', '#ee8866', '#eedd88', '#ffaabb', '#44bb99', '#b889f4', '#bbcc33', '#dddddd', '#c95c88'];

/** How many colours there are for cables and their regions: roles `region0`, `region1` and so on. */
export const REGION_COLORS = MUTED.length;

/** The role of the colour of a cable, the same everywhere. */
export const cableRole = (index) => `region${index % REGION_COLORS}`;

const roles = (name, colors) => Object.fromEntries(colors.map((color, index) => [name.replace('#', index), color]));

// Walls have these, far from the blue of what can be reached; the palettes "vibrant" and "muted" of Paul Tol.
const WALLS = ['#cc3311', '#882255', '#999933', '#ee3377', '#661100', '#aa4499', '#777777'];
const WALL_EDGES = ['#661a09', '#441129', '#4d4d1a', '#771a3c', '#330800', '#552250', '#333333'];
const PALE_WALLS = ['#ee5533', '#cc4488', '#bbbb44', '#ff6699', '#aa5544', '#cc66cc', '#999999'];
const PALE_WALL_EDGES = ['#f5c5ba', '#e8b5cf', '#e3e3b5', '#fbc6d9', '#e6b8b0', '#eac6e6', '#dddddd'];

/** The role of the colour of a wall: `wall0`, `wall1` and so on, with edges in `wall0Edge` and so on. */
export const wallRole = (index) => `wall${index % WALLS.length}`;

// What limits a motion: the palette of Okabe and Ito.
const LIMITS = {
  limitSpeed: '#0072b2',
  limitAcceleration: '#e69f00',
  limitTurnSpeed: '#6a3d9a',
  limitTurnAcceleration: '#f0e442',
  limitJerk: '#cc79a7',
  limitCableSpeed: '#56b4e9',
  limitCableAcceleration: '#d55e00',
  limitTension: '#009e73',
};

const LIGHT = {
  text: '#1b1f24',
  muted: '#545c66',
  panel: 'rgb(255 255 255 / 88%)',
  border: '#c9cfd6',
  button: '#eceff3',
  focus: '#0059c9',
  ...roles('region#', MUTED),
  ...LIMITS,
  ...roles('wall#', WALLS),
  ...roles('wall#Edge', WALL_EDGES),
  reachable: '#3f8fd0',
  reachableEdge: '#1d5c94',
  background: '#f6f7f9',
  platform: '#0072b2',
  platformEdge: '#003b5c',
  obstacle: '#c3b391',
  obstacleEdge: '#5a4d33',
  cable: '#2b2f36',
  outlet: '#000000',
  rawPath: '#80868f',
  tree: '#3b7ea1',
  finalPath: '#009e73',
  waypoint: '#00664a',
  ghost: '#b0578d',
  highlight: '#6a3d9a',
  frame: '#545c66',
  workspace: '#8d97a3',
  floor: '#8d97a3',
  violation: '#d40000',
  shadow: '#000000',
  good: '#00704f',
  warn: '#8a5a00',
};

const DARK = {
  text: '#eceff3',
  muted: '#a9b1bb',
  panel: 'rgb(30 34 41 / 88%)',
  border: '#434b56',
  button: '#333a44',
  focus: '#8cc4ff',
  ...roles('region#', PALE),
  ...LIMITS,
  ...roles('wall#', PALE_WALLS),
  ...roles('wall#Edge', PALE_WALL_EDGES),
  reachable: '#4ea3e6',
  reachableEdge: '#a8d4f7',
  background: '#14171c',
  platform: '#56b4e9',
  platformEdge: '#d3edfb',
  obstacle: '#a39273',
  obstacleEdge: '#e9dfc9',
  cable: '#d8dce2',
  outlet: '#ffffff',
  rawPath: '#969ca6',
  tree: '#86bfdc',
  finalPath: '#14c795',
  waypoint: '#a5f0d9',
  ghost: '#e29ac1',
  highlight: '#d9b8ff',
  frame: '#a9b1bb',
  workspace: '#68717d',
  floor: '#68717d',
  violation: '#ff6b5e',
  shadow: '#000000',
  good: '#3ddbaa',
  warn: '#f0b23c',
};

/**
 * Keeps the colours of materials, page and 3D background in step with the look the reader prefers: that of the system,
 * until `toggle` is called.
 */
export function createTheme(onChange) {
  const query = window.matchMedia('(prefers-color-scheme: dark)');
  const painters = new Set();
  let chosen = null;
  let printing = false;
  const isDark = () => !printing && (chosen ?? query.matches);
  const palette = () => (isDark() ? DARK : LIGHT);

  function apply() {
    const colors = palette();
    document.documentElement.style.colorScheme = isDark() ? 'dark' : 'light';
    for (const [role, color] of Object.entries(colors)) {
      document.documentElement.style.setProperty(`--${role}`, color);
    }
    for (const { bound, watchers } of painters) {
      for (const { color, role } of bound) color.set(colors[role]);
      for (const watcher of watchers) watcher();
    }
    onChange();
  }

  function createPainter() {
    const bound = [];
    const watchers = [];
    const painter = { bound, watchers };
    painters.add(painter);
    const bind = (color, role) => {
      bound.push({ color, role });
      color.set(palette()[role]);
    };
    const paint = (material, role) => {
      bind(material.color, role);
      return material;
    };
    const watch = (watcher) => watchers.push(watcher);
    return { bind, paint, watch, release: () => painters.delete(painter) };
  }

  function toggle() {
    chosen = !isDark();
    apply();
  }

  function setPrinting(value) {
    printing = value;
    apply();
  }

  query.addEventListener('change', apply);
  apply();
  return {
    /** From light to dark and back. */
    toggle,
    /** Paper is light. */
    setPrinting,
    /**
     * `bind` ties a colour to a role of the palette, `paint` that of a material, `watch` runs a function whenever the
     * colours have changed; `release` unties them all, once what they belong to is replaced.
     */
    createPainter,
  };
}
