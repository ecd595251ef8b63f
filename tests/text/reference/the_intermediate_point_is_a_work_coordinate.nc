O1 (REF-1: G90 G28 Z0 goes to work zero first)
#5223=-300.
G90 G00 Z50. (expect moves: rapid Z-250)
G28 Z0 (expect moves: rapid Z-300; rapid Z0)
M30
