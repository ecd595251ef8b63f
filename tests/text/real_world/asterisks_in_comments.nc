O1 (HOLE*PATTERN*2)
G0(TO*THE*FIRST*HOLE)X1. (expect moves: rapid X1)
M30
