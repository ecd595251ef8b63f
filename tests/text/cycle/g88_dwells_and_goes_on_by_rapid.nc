O1 (CYC-9: in a batch run nobody retracts by hand)
S500 M03
G90 G00 Z50.
G98 G88 X0 Y0 Z-10. R2. P100 F100
G80
M30
(finally machine Z50)
(finally records: spindle cw 500; dwell 0.1; spindle cw 500)
