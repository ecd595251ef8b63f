O1 (the moves go on in the same direction)
G90 G01 X10. F100 ,R2. (expect moves: line X10)
X20. (expect moves: line X20)
M30
