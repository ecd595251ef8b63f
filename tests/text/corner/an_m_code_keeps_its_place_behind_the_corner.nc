O1 (M09 of the block comes when its move is over)
G90 G01 X10. F100 ,R2. M09
Y10.
M30
(finally records: coolant off)
(finally moves: line X8; ccw X10 Y2; line Y10)
