O1 (CYC-11: back at the hole in the end)
S500 M03
G90 G00 Z50.
G99 G76 X10. Y10. Z-10. R2. Q0.5 P100 F100
G80
M30
(finally machine X10 Y10 Z2)
(finally records: spindle cw 500; dwell 0.1; spindle cw 500)
