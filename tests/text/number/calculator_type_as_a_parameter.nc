(run with: --param DPI=1)
O1 (NUM-7: the dwell of G04 X is in seconds)
G04 X2
G90 G00 X7 (expect moves: rapid X7)
M30
(finally records: dwell 2)
