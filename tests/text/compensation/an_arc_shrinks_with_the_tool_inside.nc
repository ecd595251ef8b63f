(run with: --set #13001=5)
O1 (CRC-10: 10 - 5, tangent on both ends)
G90 G00 Y-20.
G42 D1 G01 X0 Y0 F100
Y50.
G02 X10. Y60. R10.
G01 X50.
G40 Y80.
M30
(finally moves: rapid X0 Y-20; line X5 Y0; line X5 Y50; cw X10 Y55 @10,50; line X50 Y55; line X50 Y80)
