(run with: --machine lathe2)
O1 (turning, cycles along a shape: nine passes, the shape with its allowances, G70)
G97 S500 M03
N1 G00 X100. Z2.
N2 G71 U3.5 R1.
N3 G71 P10 Q50 U1.0 W0.5 F0.3 (expect moves: rapid X101 Z2.5; rapid X94 Z2.5; line X94 Z-59.5; rapid X96 Z-58.5; rapid X96 Z2.5; rapid X87 Z2.5; line X87 Z-59.5; rapid X89 Z-58.5; rapid X89 Z2.5; rapid X80 Z2.5; line X80 Z-59.5; rapid X82 Z-58.5; rapid X82 Z2.5; rapid X73 Z2.5; line X73 Z-59.5; rapid X75 Z-58.5; rapid X75 Z2.5; rapid X66 Z2.5; line X66 Z-59.5; rapid X68 Z-58.5; rapid X68 Z2.5; rapid X59 Z2.5; line X59 Z-37.5; rapid X61 Z-36.5; rapid X61 Z2.5; rapid X52 Z2.5; line X52 Z-30.5; rapid X54 Z-29.5; rapid X54 Z2.5; rapid X45 Z2.5; line X45 Z-23.5; rapid X47 Z-22.5; rapid X47 Z2.5; rapid X41 Z2.5; line X41 Z-19.5; rapid X43 Z-18.5; rapid X43 Z2.5; rapid X100 Z2)
N10 G00 X40. (expect moves: rapid X41 Z2.5; rapid X40 Z2)
N20 G01 Z-20. F0.15 (expect moves: line X41 Z-19.5 F0.3; line X40 Z-20 F0.15)
N30 X60. Z-40. (expect moves: line X61 Z-39.5; line X60 Z-40)
N40 Z-60. (expect moves: line X61 Z-59.5; line X60 Z-60)
N50 X100. (expect moves: line X101 Z-59.5; line X100 Z-60; rapid X100 Z2)
N60 G70 P10 Q50 (expect moves: none)
M30
