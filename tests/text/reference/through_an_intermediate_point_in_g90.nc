O1 (REF-1: 5, then 2, then 0)
G90 G00 Z5.
G90 G28 Z2. (expect moves: rapid Z2; rapid Z0)
M30
