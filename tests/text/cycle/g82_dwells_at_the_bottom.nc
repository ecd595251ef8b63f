O1 (CYC-2: P500 is half a second)
G90 G00 Z10.
G99 G82 X0 Y0 Z-5. R2. P500 F100 (expect moves: rapid Z2; line Z-5; rapid Z2)
G80
M30
(finally records: dwell 0.5)
