/**
 * The panel's symbols on a grid of 24, after the manner of ISO 7000 and of machine tools' key caps: a diamond is a program,
 * a bar is on, a ring is stop, a rectangle is a block, an arrow is a motion, a wave is feed.
 */
export const ICONS = {
  // Modes
  edit: '<path d="M5 4h9M5 8.500h6M5 13h4M5 17.500h3"/><path d="m11 19 1-4 7.500-7.500 3 3L15 18z"/>',
  mdi: '<rect x="3" y="14" width="18" height="6"/><path d="M12 2.500v8M8.800 7.500 12 11l3.200-3.500"/><path d="M6.500 17h3M12 17h5"/>',
  auto: '<path d="m8.500 5 6 7-6 7-6-7z"/><path d="M14.500 12h7M18.500 9l3 3-3 3"/>',
  jog: '<path d="M2 8c2.500-4 5-4 7.500 0s5 4 7.500 0"/><path d="M2 17h18M16.500 13.500 20 17l-3.500 3.500"/>',
  ref: '<circle cx="12" cy="12" r="7"/><path d="M12 12V5a7 7 0 0 1 7 7zM12 12v7a7 7 0 0 1-7-7z" fill="currentColor" stroke="none"/><path d="M12 2v3M12 19v3M2 12h3M19 12h3"/>',
  teach:
    '<path d="M4 19 9 9l6 4 5-8"/><g fill="currentColor" stroke="none"><circle cx="4" cy="19" r="2"/><circle cx="9" cy="9" r="2"/><circle cx="15" cy="13" r="2"/></g><path d="M18 17h6M21 14v6"/>',
  // Run
  'cycle-start':
    '<path d="m12 2.500 8 9.500-8 9.500L4 12z"/><path d="M12 7.500v9" stroke-width="2.600"/>',
  'feed-hold':
    '<path d="m12 2.500 8 9.500-8 9.500L4 12z"/><circle cx="12" cy="12" r="3.300" stroke-width="2.200"/>',
  reset:
    '<path d="M7.500 20 13 4M12.500 20 18 4" stroke-width="2"/><path d="M2 12h5M4.500 9.500 2 12l2.500 2.500"/>',
  interrupt: '<path d="M2 12h5M17 12h5"/><path d="M13.500 3 8.500 12.500h7L10.500 21"/>',
  // Switches
  'single-block':
    '<path d="M2 12h5M4.800 9.500 7.300 12l-2.500 2.500"/><rect x="9.500" y="8" width="8" height="8"/><path d="M21 5v14" stroke-width="2"/>',
  'optional-stop':
    '<path d="M2 12h4.500M4.300 9.500 6.800 12l-2.500 2.500"/><circle cx="15" cy="12" r="6" stroke-dasharray="3 2.280"/><path d="M15 9v6"/>',
  'block-skip':
    '<rect x="8" y="13" width="8" height="6" stroke-dasharray="2.500 2"/><path d="M3 15C3 3 21 3 21 13M18 10.500l3 3 2.500-3"/>',
  'dry-run':
    '<path d="m8 5.500 5 6.500-5 6.500L3 12z" stroke-dasharray="2.500 2"/><path d="M14 12h8M19 9l3 3-3 3M14 7.500h4M14 16.500h4"/>',
  'machine-lock':
    '<rect x="10" y="12" width="11" height="8.500" rx="1"/><path d="M12.500 12V9.500a3 3 0 0 1 6 0V12"/><path d="M3 3v11h4M3 3 1 6M3 3l2 3"/>',
  // Overrides
  feed: '<path d="M2 12c2-4.500 4-4.500 6 0s4 4.500 6 0M14 12h8M19 9l3 3-3 3"/>',
  rapid:
    '<path d="M2 7.500h17M15.500 4 19 7.500 15.500 11M2 16.500h17M15.500 13l3.500 3.500-3.500 3.500"/>',
  spindle:
    '<path d="M9 2.500h6v6H9zM12 8.500v5"/><path d="M5 13c-3 5 4 8 8 8s8-2 8-5-4-4-7-4"/><path d="m16.500 9-3 3 3 3"/>',
  power: '<path d="M9 2.500h6v4.500l-3 3-3-3zM12 10v10M6 20h12M7 14.500l2 2M17 14.500l-2 2"/>',
  // Stepping
  'step-over':
    '<path d="M3 13C3 4.500 19 4.500 19 12M15.500 9.500l3.500 3 2.800-3.500"/><circle cx="11" cy="18" r="2.200" fill="currentColor" stroke="none"/>',
  'step-into':
    '<path d="M11 2.500v10M7 9l4 4 4-4"/><circle cx="11" cy="19" r="2.200" fill="currentColor" stroke="none"/>',
  'step-out':
    '<path d="M11 14V3M7 6.500l4-4 4 4"/><circle cx="11" cy="19" r="2.200" fill="currentColor" stroke="none"/>',
  'step-back':
    '<path d="M20 13C20 4.500 4 4.500 4 12M7.500 9.500 4 12.500 1.500 9"/><circle cx="12" cy="18" r="2.200" fill="currentColor" stroke="none"/>',
  'run-to':
    '<path d="M3 8h10M9.500 4.500 13 8l-3.500 3.500"/><path d="M18 3v18" stroke-dasharray="3 2.500"/><path d="M3 16h9"/>',
  'start-at':
    '<path d="M4 3v18M8 6h12M8 18h12"/><path d="M8 12h9M13.500 8.500 17 12l-3.500 3.500"/>',
  // Program and library
  library: '<path d="M3 6h6l2 2.500h10V19H3z"/>',
  save: '<path d="M4 4h13l3 3v13H4zM8 4v5h8V4M8 20v-6h8v6"/>',
  load: '<path d="M12 3v10M8 9.500l4 4 4-4M4 15v5h16v-5"/>',
  upload: '<path d="M12 14V4M8 7.500l4-4 4 4M4 15v5h16v-5"/>',
  new: '<path d="M6 3h8l4 4v14H6zM14 3v4h4"/><path d="M12 11v6M9 14h6"/>',
  rename: '<path d="M4 20h16M5 15 15.500 4.500l3 3L8 18l-3.500.500z"/>',
  trash: '<path d="M4 6h16M9 6V3.500h6V6M6.500 6l1 15h9l1-15M10 10v7M14 10v7"/>',
  history: '<path d="M4 12a8 8 0 1 0 2.500-5.800M6.500 3v3.500H10"/><path d="M12 8v4.500l3 2"/>',
  undo: '<path d="M4 9h10a5 5 0 0 1 0 10H8M7.500 5.500 4 9l3.500 3.500"/>',
  // Picture
  iso: '<path d="m12 3 8 4.500v9L12 21l-8-4.500v-9zM4 7.500l8 4.500 8-4.500M12 12v9"/>',
  top: '<path d="m12 3 8 4.500-8 4.500-8-4.500z" fill="currentColor" fill-opacity=".35"/><path d="M4 7.500v9L12 21l8-4.500v-9M12 12v9"/>',
  front:
    '<path d="M4 7.500v9L12 21v-9z" fill="currentColor" fill-opacity=".35"/><path d="m4 7.500 8-4.500 8 4.500v9L12 21M12 12l8-4.500"/>',
  right:
    '<path d="m12 12 8-4.500v9L12 21z" fill="currentColor" fill-opacity=".35"/><path d="m12 12-8-4.500 8-4.500 8 4.500M4 7.500v9l8 4.500"/>',
  fit: '<path d="M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5"/><rect x="8.500" y="8.500" width="7" height="7"/>',
  layers: '<path d="m12 3 9 5-9 5-9-5zM3 12.500l9 5 9-5M3 17l9 5 9-5"/>',
  'zoom-in':
    '<circle cx="10.500" cy="10.500" r="6.500"/><path d="m15.500 15.500 5 5M7.500 10.500h6M10.500 7.500v6"/>',
  'zoom-out':
    '<circle cx="10.500" cy="10.500" r="6.500"/><path d="m15.500 15.500 5 5M7.500 10.500h6"/>',
  measure:
    '<path d="m3 16.500 13.500-13.500 4.500 4.500L7.500 21zM7 12.500l2 2M10 9.500l3 3M13 6.500l2 2"/>',
  flip: '<path d="M12 3v18" stroke-dasharray="3 2.500"/><path d="M9 7 3 17h6zM15 7l6 10h-6z"/>',
  live: '<circle cx="12" cy="12" r="3.500" fill="currentColor" stroke="none"/><path d="M6 6a8.500 8.500 0 0 0 0 12M18 6a8.500 8.500 0 0 1 0 12"/>',
  back: '<path d="M14.500 5 8 12l6.500 7"/>',
  forward: '<path d="M9.500 5 16 12l-6.500 7"/>',
  // Panel
  machine: '<path d="M4 21V4h5v4h6V4h5v17zM12 8v6M10 14h4l-2 3.500z"/>',
  settings:
    '<circle cx="12" cy="12" r="3"/><path d="M12 2.500v4M12 17.500v4M2.500 12h4M17.500 12h4M5.300 5.300l2.800 2.800M15.900 15.900l2.800 2.800M18.700 5.300l-2.800 2.800M8.100 15.900l-2.800 2.800"/>',
  help: '<path d="M8.500 9a3.500 3.500 0 1 1 5 3.200c-1.200.600-1.500 1.300-1.500 2.800"/><circle cx="12" cy="19" r="1.300" fill="currentColor" stroke="none"/>',
  book: '<path d="M12 6C9 4 6 4 3 5v14c3-1 6-1 9 1 3-2 6-2 9-1V5c-3-1-6-1-9 1zM12 6v14"/>',
  sun: '<circle cx="12" cy="12" r="4"/><path d="M12 2v3M12 19v3M2 12h3M19 12h3M4.900 4.900 7 7M17 17l2.100 2.100M19.100 4.900 17 7M7 17l-2.100 2.100"/>',
  moon: '<path d="M20 14.500A8.500 8.500 0 0 1 9.500 4 8.500 8.500 0 1 0 20 14.500z"/>',
  person: '<circle cx="12" cy="8" r="4"/><path d="M4 21c0-5 3.500-7.500 8-7.500s8 2.500 8 7.500"/>',
  alarm:
    '<path d="M12 3 2.500 20.500h19z"/><path d="M12 9.500v5.500" stroke-width="2"/><circle cx="12" cy="17.700" r="1.200" fill="currentColor" stroke="none"/>',
  check: '<path d="m4 12.500 5 5L20 6.500"/>',
  close: '<path d="m5 5 14 14M19 5 5 19"/>',
  plus: '<path d="M12 4v16M4 12h16"/>',
  minus: '<path d="M4 12h16"/>',
  down: '<path d="m5 9 7 7 7-7"/>',
  link: '<path d="M10 7H7a5 5 0 0 0 0 10h3M14 7h3a5 5 0 0 1 0 10h-3M8 12h8"/>',
  'no-link': '<path d="M9 7H7a5 5 0 0 0 0 10h2M15 7h2a5 5 0 0 1 0 10h-2M3 3l18 18"/>',
  pause: '<path d="M8 5v14M16 5v14" stroke-width="2.600"/>',
  stop: '<rect x="6" y="6" width="12" height="12"/>',
  flag: '<path d="M5 21V3M5 4h13l-3 4 3 4H5"/>',
  dot: '<circle cx="12" cy="12" r="5" fill="currentColor" stroke="none"/>',
  home: '<path d="m3 11.500 9-8 9 8M6 9.500V20h12V9.500"/>',
  point:
    '<circle cx="12" cy="12" r="2.500" fill="currentColor" stroke="none"/><path d="M12 3v5M12 16v5M3 12h5M16 12h5"/>',
  line: '<path d="M5 19 19 5"/><g fill="currentColor" stroke="none"><circle cx="5" cy="19" r="2.200"/><circle cx="19" cy="5" r="2.200"/></g>',
  'arc-via':
    '<path d="M4 19C4 9 10 5 20 5"/><circle cx="8" cy="9.500" r="2.600" fill="currentColor" stroke="none"/>',
  'circle-end':
    '<circle cx="12" cy="12" r="8"/><circle cx="20" cy="12" r="2.600" fill="currentColor" stroke="none"/><path d="M12 20l-3 2M12 20l-3-2"/>',
  'arc-end':
    '<path d="M4 19C4 9 10 5 20 5"/><circle cx="20" cy="5" r="2.600" fill="currentColor" stroke="none"/>',
} as const;

export type IconName = keyof typeof ICONS;
