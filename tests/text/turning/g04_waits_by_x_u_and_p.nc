(run with: --machine lathe2)
O1 (P counts milliseconds)
G97S500M03
G04X1.5
G04U.25
G04P300
G04X500
M30
(finally records: dwell 1.5; dwell 0.25; dwell 0.3; dwell 0.5)
