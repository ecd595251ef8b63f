O1 (P, L, Q, R, I, J, K mean something beside some codes only)
G90 G01 X1. R5. F100 (expect assumed: R5 is ignored) (expect moves: line X1)
G00 X2. P7 (expect assumed: P7 is ignored)
G02 X4. I1. J0
G81 X5. Z-1. R1. K2 L2
G80
G04 P10
M98 P2 L2
M30
O2
G53 Z0 Q3. (expect assumed: Q3 is ignored)
M99
