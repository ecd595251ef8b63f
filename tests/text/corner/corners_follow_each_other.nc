O1 (the second side is cut at both ends)
G90 G01 X10. F100 ,R2.
Y10. ,C1. (expect moves: line X10 Y9; line X9 Y10)
X0 (expect moves: line X0 Y10)
M30
