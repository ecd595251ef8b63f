O1 (CYC-5: counterclockwise on the way out)
S500 M03
G90 G00 Z50.
G98 G84 X0 Y0 Z-10. R2. P100 F500 (expect moves: rapid Z2; line Z-10 F500; line Z2 F500; rapid Z50)
G80
M30
(finally records: spindle cw 500; dwell 0.1; spindle ccw 500; dwell 0.1; spindle cw 500)
