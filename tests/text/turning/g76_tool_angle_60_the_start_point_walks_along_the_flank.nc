(run with: --machine lathe2)
O1 (G76 tool angle 60: the start point walks along the flank)
G97S500M03
G00X34.Z5.
G76P010060Q100R.05
G76X27.4Z-25.P1300Q450F2.
M30
(finally moves: rapid X34 Z5; rapid X29.1 Z4.7402; thread X29.1 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X28.7272 Z4.6326; thread X28.7272 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X28.4412 Z4.55; thread X28.4412 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X28.2 Z4.4804; thread X28.2 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X27.9875 Z4.4191; thread X27.9875 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X27.7875 Z4.3613; thread X27.7875 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X27.5875 Z4.3036; thread X27.5875 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X27.5 Z4.2783; thread X27.5 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X27.4 Z4.2494; thread X27.4 Z-25 F2; rapid X34 Z-25; rapid X34 Z5)
