O1 (CYC-7: rapid out, then on again)
S500 M03
G90 G00 Z50.
G98 G86 X0 Y0 Z-10. R2. F100 (expect moves: rapid Z2; line Z-10; rapid Z50)
G80
M30
(finally records: spindle cw 500; spindle cw 500)
