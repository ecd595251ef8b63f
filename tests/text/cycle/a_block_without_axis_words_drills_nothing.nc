O1 (CYC-16: M, S and a dwell)
G90 G00 Z10.
G99 G81 X1. Z-5. R2. F100
M08 (expect moves: none)
S800 (expect moves: none)
G04 X0.5 (expect moves: none)
G80
M30
(finally records: coolant flood; dwell 0.5)
