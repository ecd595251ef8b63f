(run with: --machine lathe3c)
O1 (Spindles)
G97S300M03
M05
S400M133
G00X30.Z5.C0
G84Z-10.R-3.F1.25
G80
M135
M30
(finally records: spindle cw 300; spindle stop; live spindle cw 400; live spindle ccw 400; live spindle cw 400; live spindle stop)
