O1 (CYC-18: in G18 it is Y)
G90 G00 Y10.
G18 G99 G81 X1. Z3. Y-5. R2. F100 (expect moves: rapid X1 Y10 Z3; rapid Y2; line X1 Y-5 Z3; rapid Y2)
G80
M30
