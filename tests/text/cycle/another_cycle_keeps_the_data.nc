O1 (section 10: G82 with the Z and R of G81)
G90 G00 Z10.
G99 G81 X1. Z-5. R2. F100
G82 X2. P100 (expect moves: rapid X2 Z2; line Z-5; rapid Z2)
G80
M30
(finally records: dwell 0.1)
