O1 (the speed and the system are repeated in words)
#7001=5.
S5000(S1200)M03
G54.1P1(G58)G0X0Y0 (expect moves: rapid X5 Y0)
M30
(finally records: spindle cw 5000)
