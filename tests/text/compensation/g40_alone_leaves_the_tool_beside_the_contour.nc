(run with: --set #13001=5)
O1 (CRC-12: G40 without motion; a move in Z does not take the offset away, the next one in the plane does)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F200
Y50.
G40
Z5. (expect moves: line X-5 Y50 Z5)
X10. (expect moves: line X10 Y50 Z5)
M30
