// Programs whose features the scenarios look at and edit.

/** A pocket of two layers, a profile, a round pocket and two holes. */
export const P1 = `%
O0001 (P1)
(T1 D=10. CR=0. - FLAT END MILL)
(T2 D=6. CR=0. - FLAT END MILL)
N10 G21 G90 G17
N20 T1 M06
N30 G00 X0. Y0. Z5. S3000 M03
N40 G00 X20. Y20.
N50 G01 Z-2. F100.
N60 G01 X40. F300.
N70 Y28.
N80 X20.
N90 Y20.
N100 X15. Y15.
N110 X45.
N120 Y33.
N130 X15.
N140 Y15.
N150 G00 Z5.
N160 X20. Y20.
N170 G01 Z-4. F100.
N180 X40. F300.
N190 Y28.
N200 X20.
N210 Y20.
N220 X15. Y15.
N230 X45.
N240 Y33.
N250 X15.
N260 Y15.
N270 G00 Z5.
N280 X80. Y10.
N290 G01 Z-6. F100.
N300 G01 X110. F250.
N310 G03 X115. Y15. I0. J5.
N320 G01 Y35.
N330 G03 X110. Y40. I-5. J0.
N340 G01 X80.
N350 G03 X75. Y35. I0. J-5.
N360 G01 Y15.
N370 G03 X80. Y10. I5. J0.
N380 G00 Z5.
N390 X65. Y60.
N400 G01 Z-3. F100.
N410 G02 X65. Y60. I-3. J0. F250.
N420 G00 Z5.
N430 T2 M06
N440 G00 X10. Y50.
N450 G01 Z-12. F80.
N460 G00 Z5.
N470 X30. Y50.
N480 G01 Z-12.
N490 G00 Z5.
N500 M30
%
`;

/** A pocket whose two layers are one loop. */
export const LOOPED = `%
O0002 (A POCKET IN A LOOP)
(T1 D=10. CR=0. - FLAT END MILL)
G21 G90 G17
T1 M06
G00 X0. Y0. Z5. S3000 M03
#1=2.
WHILE [#1 LE 4.] DO1
G00 X20. Y20.
G01 Z-#1 F100.
X40. F300.
Y28.
X20.
Y20.
X15. Y15.
X45.
Y33.
X15.
Y15.
G00 Z5.
#1=#1+2.
END1
M30
%
`;

/** Two frames by a macro: how large they are stands in the calls. */
export const FRAMED = `%
O0004 (A FRAME BY A MACRO)
(T1 D=10. CR=0. - FLAT END MILL)
G21 G90 G17
T1 M06
G00 X0. Y0. Z5. S3000 M03
G00 X15. Y15.
G65 P9400 A30. B18.
G00 X15. Y65.
G65 P9400 A40. B18.
M30
O9400
G01 Z-3. F100.
G91 X#1 F300.
Y#2
X-#1
Y-#2
G90 G00 Z5.
M99
%
`;

/** The shape of a roughing cycle. */
export const SHAPE = `%
O0062 (A SHAPE)
T0101
G97 S900 M03
G00 X62. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G00 X20.
G01 Z-20. F0.12
X30. Z-30.
Z-50.
N20 X62.
G70 P10 Q20
G00 X100. Z50.
M30
%
`;

/** What it is turned from, and with. */
export const SHAPE_SETUP = `[stock]
shape = "bar:60,-100,0"

[[tool]]
number = 1
type = "turning"
nose_radius = 0
tip = 3
kapr = 95
tip_angle = 80
ic = 40
`;
