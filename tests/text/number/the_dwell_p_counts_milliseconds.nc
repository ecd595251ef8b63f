O1 (NUM-8: G04 P500 is half a second)
G04 P500
M30
(finally records: dwell 0.5)
