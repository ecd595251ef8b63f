O1 (CYC-5: clockwise on the way out)
S500 M04
G90 G00 Z10.
G99 G74 X0 Y0 Z-10. R2. F500 (expect moves: rapid Z2; line Z-10; line Z2)
G80
M30
(finally records: spindle ccw 500; spindle cw 500; spindle ccw 500)
