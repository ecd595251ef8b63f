O1 (G-6)
G61 G01 X10. ,R2. F100 (expect moves: line X8 stop; ccw X10 Y2 stop)
G64 Y10. (expect moves: line Y10 pass)
M30
