O1 (CYC-10: G85 with a dwell)
G90 G00 Z50.
G98 G89 X0 Y0 Z-10. R2. P250 F100 (expect moves: rapid Z2; line Z-10; line Z2; rapid Z50)
G80
M30
(finally records: dwell 0.25)
