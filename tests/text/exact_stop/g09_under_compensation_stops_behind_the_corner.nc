O1 (G-6, CRC-9)
#13001=1.
G01 G41 D1 Y5. F100 (expect moves: line X-1 Y5 pass)
G09 Y10. (expect moves: line X-1 Y11 pass; line X0 Y11.4142 stop)
X10. Y0 (expect moves: line X10.7071 Y0.7071 pass)
G40 X20.
M30
