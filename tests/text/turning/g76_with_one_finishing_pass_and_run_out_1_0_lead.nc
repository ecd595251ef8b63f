(run with: --machine lathe2)
O1 (G76 with one finishing pass and run-out 1.0 lead)
G97S500M03
G00X34.Z5.
G76P011000Q100R.05
G76X27.4Z-25.P1300Q400F2.
M30
(finally moves: rapid X34 Z5; rapid X29.2 Z5; thread X29.2 Z-23 F2; thread X33.2 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X28.8686 Z5; thread X28.8686 Z-23 F2; thread X32.8686 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X28.6144 Z5; thread X28.6144 Z-23 F2; thread X32.6144 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X28.4 Z5; thread X28.4 Z-23 F2; thread X32.4 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X28.2 Z5; thread X28.2 Z-23 F2; thread X32.2 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X28 Z5; thread X28 Z-23 F2; thread X32 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X27.8 Z5; thread X27.8 Z-23 F2; thread X31.8 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X27.6 Z5; thread X27.6 Z-23 F2; thread X31.6 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X27.5 Z5; thread X27.5 Z-23 F2; thread X31.5 Z-25 F2; rapid X34 Z-25; rapid X34 Z5; rapid X27.4 Z5; thread X27.4 Z-23 F2; thread X31.4 Z-25 F2; rapid X34 Z-25; rapid X34 Z5)
