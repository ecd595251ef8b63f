// Programs that the scenarios run.

/** Calls a macro with local variables. Line 3 calls, line 9 changes #33. */
export const MACRO = `%
O0100 (CALLS A MACRO)
G65 P9100 A5. B2.
#500=#500+1
G91 G01 X1. F600
G90
M30
O9100 (ADDS A AND B)
#33=#1+#2
G91 G01 X#33 F2000
G90
M99
%
`;

/** Stands in line 6 until input #1003 comes; an interrupt goes 3 mm up in Y. */
export const WAITS = `%
O0300 (WAITS FOR AN INPUT)
M96 P9300
G90 G54 G00 X0. Y0.
WHILE [#1003 EQ 0] DO1
G04 P100
END1
G01 X2. F600
M97
M30
O9300
G91 G01 Y3. F600
G90
M99
%
`;

/** Long enough to be held on its way: three metres at 300 mm/min. */
export const LONG = `%
O0200 (UP AND DOWN)
G90 G54 G00 X0. Y0.
G01 X150. F300.
Y50.
X0.
Y0.
M30
%
`;

/** A groove that is cut, four millimetres deep. */
export const GROOVE = `%
O0201 (A GROOVE)
G90 G54 G00 X0. Y0. Z5.
S3000 M03
G01 Z-4. F600.
X100.
Y50.
X0.
Y0.
G00 Z5.
M30
%
`;

/** Two hours of rectangles. */
export const RUNS_FOR_HOURS = `%
O0250 (RECTANGLES)
G90 G54 G00 X0. Y0.
#500=0
WHILE [#500 LT 600] DO1
G01 X100. F2000.
Y100.
X0.
Y0.
#500=#500+1
END1
M30
%
`;

/** Divides by zero in line 5, behind a move. */
export const WRONG = `%
O0300 (DIVIDES BY ZERO)
#100=0
G91 G01 X1. F2000
#101=1/#100
G01 X5.
M30
%
`;

/** Two frames by a macro, behind blocks that bring the machine to where they are cut. Line 10 is the first of the macro. */
export function frames(begin) {
  const [first, second = 'G04 P0'] = begin.split('\n');
  return `%
O0400 (TWO FRAMES, EACH BY A MACRO)
${first}
${second}
G65 P9400 A40. B20.
G65 P9400 A20. B10.
#500=#500+1
M30
O9400 (A FRAME OF A BY B)
#33=#1
#32=#2
G91 G01 X#33 F1200
Y#32
X-#33
Y-#32
G90
M99
%
`;
}

/** The same in laser BASIC. Line 10 is the first of the subprogram behind its LOCAL. */
export const FRAMES_BASIC = `' Two frames, each by the subprogram frame
speed(40); power(60)
size=40
gosub frame
size=20
gosub frame
end
frame:
 local half   ' of the size, around the origin
 half=size/2
 move(-half, -half)
 line(half, -half)
 line(half, half)
 line(-half, half)
 line(-half, -half)
return
`;

/** As many short cuts as are asked for, along a spiral of 20 mm: a machine has soon cut them all, however many. */
export function spiral(cuts) {
  const lines = [
    '%',
    'O0900 (A LONG SPIRAL)',
    'G90 G94 G17 G21 G54',
    'G00 X0. Y0. Z5.',
    'G01 Z-1. F3000.',
  ];
  for (let i = 1; i <= cuts; i++) {
    const angle = i * 0.02;
    const radius = 1 + (i * 9) / cuts;
    lines.push(
      `X${(radius * Math.cos(angle)).toFixed(3)}Y${(radius * Math.sin(angle)).toFixed(3)}`,
    );
  }
  lines.push('G00 Z5.', 'M30', '%', '');
  return lines.join('\n');
}

/** A shaft: facing, roughing and finishing of its shape under G96, a thread. */
export const SHAFT = `%
O0060 (SHAFT)
G21 G99 G40
G28 U0 W0
G50 S2500
T0101 (ROUGHING, NOSE 0.8)
G96 S180 M03
G00 X64. Z0. M08
G01 X-1.6 F.2
G00 X62. Z2.
G71 U2.5 R0.5
G71 P100 Q200 U0.6 W0.1 F0.25
N100 G00 X18.
G01 Z0. F0.12
X20. Z-1.
Z-24.
X26.
G03 X32. Z-27. R3.
G01 Z-40.
G02 X40. Z-44. R4.
G01 X48.
X52. Z-58.
N200 X62.
G42 G70 P100 Q200
G40 G00 X100. Z60. T0100
T0303 (THREAD)
G97 S900 M03
G00 X26. Z5.
G76 P010060 Q100 R0.05
G76 X17.546 Z-20. P1227 Q400 F2.
G00 X100. Z60. T0300 M09
M30
%
`;

/** A slot and a pocket beside a clamp, a rapid through what is left, two holes: with findings of each kind. */
export const CLAMPED = `%
O0007 (CLAMPED)
G90 G54 G17 G21 G49 G40 G80
T1 M06
S3000 M03
G00 X0. Y20. Z5.
G01 Z-4. F800.
X70.
G00 Z5.
X10. Y45.
G01 Z-6. F300.
X50.
G00 Z-3. X30. Y30.
G00 Z20.
X-15. Y10. Z2.
X-15. Y50.
G00 Z20.
T2 M06
S2000 M03
G00 X50. Y10.
G81 Z-12. R2. F200.
X58.
G80
M30
%
`;

/** Two grooves, a step and a shoulder: the mill is engaged over 180, 60 and 90 degrees. */
export const GROOVES = `%
O0009 (GROOVES)
(T1 D=10. CR=0. - FLAT END MILL)
G90 G54 G17 G21 G49 G40 G80
T1 M06
S3000 M03
G00 X-10. Y20. Z5.
G01 Z-5. F300.
X80. F600.
G00 Z5.
X-10. Y40.
G01 Z-2.9 F300.
X80. F600.
G00 Z5.
X-10. Y-2.5
G01 Z-6. F300.
X80. F600.
G00 Z5.
X-10. Y60.
G01 Z-2. F300.
X80. F600.
G00 Z50.
M30
%
`;

/** What it shall be, in (Y, Z): the first groove is 0.2 mm too deep, of the second 0.1 mm is left. */
export const GROOVES_DESIGN = [
  [0, -20],
  [60, -20],
  [60, -2],
  [55, -2],
  [55, 0],
  [45, 0],
  [45, -3],
  [35, -3],
  [35, 0],
  [25, 0],
  [25, -4.8],
  [15, -4.8],
  [15, 0],
  [2.5, 0],
  [2.5, -6],
  [0, -6],
];

/** A bar turned to two diameters. */
export const STEPPED = `%
O0010 (STEPPED)
G50 S2000
G97 S500 M03
T0101
G00 X52. Z2.
G01 X40. F0.3
Z-30.
X52.
G00 Z2.
X30.
G01 Z-10.
X52.
G00 X80. Z20.
M30
%
`;

/** What it shall be, in (Z, radius): the middle is 0.1 mm too thin, of the end 0.2 mm is left. */
export const STEPPED_DESIGN = [
  [-60, 25],
  [-30, 25],
  [-30, 20.1],
  [-10, 20.1],
  [-10, 14.8],
  [0, 14.8],
];

/** A surface of waves, finished line by line with a ball: most tiles change while it runs. */
export const RELIEF = (() => {
  const lines = [
    '%',
    'O0008 (RELIEF)',
    'G90 G54 G17 G21 G49 G40 G80',
    '(T1 D=10. - flat end mill)',
  ];
  lines.push('(T2 D=6. - ball end mill)', 'T1 M06', 'S6000 M03', 'G00 X-10. Y-10. Z5.');
  for (let y = -5; y <= 105; y += 8) {
    lines.push(`G00 X-10. Y${y}.`, 'G01 Z-3. F3000.', 'X110.', 'G00 Z5.');
  }
  lines.push('G00 Z20.', 'T2 M06', 'S9000 M03');
  for (let row = 0; row <= 100; row += 1) {
    lines.push(`G00 X0. Y${row}. Z5.`);
    for (let x = 0; x <= 100; x += 2) {
      const z = -7 - 3 * Math.sin(x / 9) * Math.cos(row / 11);
      lines.push(`G01 X${x}. Y${row}. Z${z.toFixed(3)} F4000.`);
    }
    lines.push('G00 Z5.');
  }
  return [...lines, 'M30', '%', ''].join('\n');
})();
