(run with: --machine lathe3c)
O1 (Spindles)
G97S1200
M134
M30
(finally records: live spindle ccw 1200)
