O1 (NUM-7: G04 X500 is half a second)
G04 X500
G04 X1.5
M30
(finally records: dwell 0.5; dwell 1.5)
