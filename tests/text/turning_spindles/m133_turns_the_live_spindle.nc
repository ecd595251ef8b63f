(run with: --machine lathe3c)
O1 (Spindles)
G97S500M03
M05
G97S2000M133
S900
M135
M03S600
M30
(finally records: spindle cw 500; spindle stop; live spindle cw 2000; live spindle cw 900; live spindle stop; spindle cw 600)
