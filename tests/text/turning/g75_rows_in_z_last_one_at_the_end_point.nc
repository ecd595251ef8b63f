(run with: --machine lathe2)
O1 (G75: rows in Z, last one at the end point)
G97S500M03
G00X46.Z-12.
G75R.5
G75X34.Z-19.5P2500Q3000R.15F.08
M30
(finally moves: rapid X46 Z-12; line X41 Z-12; rapid X42 Z-12; line X36 Z-12; rapid X37 Z-12; line X34 Z-12; rapid X46 Z-12; rapid X46 Z-15; line X41 Z-15; rapid X42 Z-15; line X36 Z-15; rapid X37 Z-15; line X34 Z-15; rapid X34 Z-14.85; rapid X46 Z-14.85; rapid X46 Z-18; line X41 Z-18; rapid X42 Z-18; line X36 Z-18; rapid X37 Z-18; line X34 Z-18; rapid X34 Z-17.85; rapid X46 Z-17.85; rapid X46 Z-19.5; line X41 Z-19.5; rapid X42 Z-19.5; line X36 Z-19.5; rapid X37 Z-19.5; line X34 Z-19.5; rapid X34 Z-19.35; rapid X46 Z-19.35; rapid X46 Z-12)
