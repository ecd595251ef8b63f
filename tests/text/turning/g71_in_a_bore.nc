(run with: --machine lathe2)
O1 (G71 in a bore)
G97S500M03
G00X18.Z2.
G71U2.5R.5
G71P10Q50U-.4W.1F.3
N10G00X50.
G01Z-10.F.15
G01X36.Z-24.
G01Z-34.
N50G01X18.
G70P10Q50
M30
(finally moves: rapid X18 Z2; rapid X17.6 Z2.1; rapid X22.6 Z2.1; line X22.6 Z-33.9; rapid X21.6 Z-33.4; rapid X21.6 Z2.1; rapid X27.6 Z2.1; line X27.6 Z-33.9; rapid X26.6 Z-33.4; rapid X26.6 Z2.1; rapid X32.6 Z2.1; line X32.6 Z-33.9; rapid X31.6 Z-33.4; rapid X31.6 Z2.1; rapid X37.6 Z2.1; line X37.6 Z-21.9; rapid X36.6 Z-21.4; rapid X36.6 Z2.1; rapid X42.6 Z2.1; line X42.6 Z-16.9; rapid X41.6 Z-16.4; rapid X41.6 Z2.1; rapid X47.6 Z2.1; line X47.6 Z-11.9; rapid X46.6 Z-11.4; rapid X46.6 Z2.1; rapid X49.6 Z2.1; line X49.6 Z-9.9; rapid X48.6 Z-9.4; rapid X48.6 Z2.1; rapid X49.6 Z2.1; line X49.6 Z-9.9; line X35.6 Z-23.9; line X35.6 Z-33.9; line X17.6 Z-33.9; rapid X18 Z2; rapid X50 Z2; line X50 Z-10; line X36 Z-24; line X36 Z-34; line X18 Z-34; rapid X18 Z2)
(finally work X18 Z2)
