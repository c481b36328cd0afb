/** Small drawings of the bar; they take the colour of the text around them. */
const box = { width: 24, height: 24, viewBox: '0 0 24 24', 'aria-hidden': true } as const;

export const FlagIcon = () => (
  <svg {...box}>
    <path
      fill="currentColor"
      d="M6 3a1.200 1.200 0 0 1 1.200 1.200c4.300-2 6.500 1.800 11.600-.2.600-.2 1.200.2 1.200.8v8.400c0 .5-.3.9-.8 1.100-5 2-7.400-1.900-12 .2v5.300a1.200 1.200 0 1 1-2.400 0V4.200A1.200 1.200 0 0 1 6 3z"
    />
  </svg>
);
export const StopIcon = () => (
  <svg {...box}>
    <path
      fill="currentColor"
      d="M8.300 2.500h7.400c.5 0 1 .2 1.300.5l4 4c.3.300.5.800.5 1.300v7.400c0 .5-.2 1-.5 1.300l-4 4c-.3.300-.8.500-1.300.5H8.300c-.5 0-1-.2-1.300-.5l-4-4c-.3-.3-.5-.8-.5-1.300V8.300c0-.5.2-1 .5-1.300l4-4c.3-.3.8-.5 1.300-.5z"
    />
  </svg>
);
export const PauseIcon = () => (
  <svg {...box}>
    <rect x="5.500" y="4" width="4.500" height="16" rx="1.800" fill="currentColor" />
    <rect x="14" y="4" width="4.500" height="16" rx="1.800" fill="currentColor" />
  </svg>
);
export const PlayIcon = () => (
  <svg {...box}>
    <path
      fill="currentColor"
      d="M7 4.800c0-1.100 1.200-1.800 2.100-1.200l10.200 6.900c.9.600.9 1.900 0 2.500L9.100 20.400C8.200 21 7 20.300 7 19.200z"
    />
  </svg>
);
export const UndoIcon = ({ flipped }: { flipped?: boolean }) => (
  <svg {...box} style={flipped ? { transform: 'scaleX(-1)' } : undefined}>
    <path
      fill="none"
      stroke="currentColor"
      stroke-width="2.400"
      stroke-linecap="round"
      stroke-linejoin="round"
      d="M8.500 5 4.500 9l4 4M5 9h9a5.200 5.200 0 0 1 0 10.400h-4"
    />
  </svg>
);
export const StageIcon = () => (
  <svg {...box}>
    <rect
      x="3"
      y="4.500"
      width="18"
      height="15"
      rx="3"
      fill="none"
      stroke="currentColor"
      stroke-width="2.200"
    />
    <path d="M14.500 5v14" stroke="currentColor" stroke-width="2.200" />
  </svg>
);
export const Eye = () => (
  <svg width="30" height="30" viewBox="0 0 32 32" aria-hidden>
    <path
      d="M2 16C6 8.500 11 5.500 16 5.500S26 8.500 30 16c-4 7.500-9 10.500-14 10.500S6 23.500 2 16z"
      fill="#1f2a44"
    />
    <circle cx="16" cy="16" r="7" fill="#fff" />
    <circle cx="17.500" cy="16" r="4.200" fill="#0f8f82" />
    <circle cx="19" cy="14.500" r="1.300" fill="#fff" />
  </svg>
);
