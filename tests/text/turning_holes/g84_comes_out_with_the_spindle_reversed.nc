(run with: --machine lathe3c)
O1 (Holes)
G99G97S500M03
G00X0Z20.
G84Z-10.R-15.F1.5 (expect moves: rapid Z5; line Z-10 F1.5; line Z5 F1.5; rapid Z20)
G80
M30
(finally records: spindle cw 500; spindle ccw 500; spindle cw 500)
