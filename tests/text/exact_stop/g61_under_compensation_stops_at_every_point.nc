O1 (G-6, CRC-9)
#13001=1.
G61 G01 G41 D1 Y5. F100 (expect moves: line X-1 Y5 stop)
Y10. (expect moves: line X-1 Y11 stop; line X1 Y11 stop)
Y5. (expect moves: line X1 Y5 stop)
G40 X20.
M30
