(run with: --set #13001=5)
O1 (CRC-8: G41 with a turn to the right meets at -5,55)
G90 G00 Y-20.
G41 D1 G01 X0 Y0 F100
Y50. (expect moves: line X-5 Y55)
X50.
G40 Y60.
M30
