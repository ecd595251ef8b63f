O1 (CYC-8: G99 acts as G98, the spindle starts twice more)
S500 M03
G90 G00 Z10.
G99 G87 X10. Y10. Z-5. R-20. Q1. P100 F100
G80
M30
(finally machine X10 Y10 Z10)
(finally records: spindle cw 500; spindle cw 500; dwell 0.1; spindle cw 500)
