O1 (G-6)
G09 G01 X10. ,R2. F100 (expect moves: line X8 pass; ccw X10 Y2 stop)
Y10. ,C1. (expect moves: line Y9 pass; line X11 Y10 pass)
X20. (expect moves: line X20 pass)
M30
