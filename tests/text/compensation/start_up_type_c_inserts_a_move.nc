(run with: --param SUP/SUV=C --set #13001=5)
O1 (CRC-6: G41 without motion steps aside at once)
G90 G01 X0 Y0 F100
G41 D1
Y50.
X50.
G40 Y80.
M30
(finally moves: line X-5 Y0; line X-5 Y55; line X50 Y55; line X50 Y80)
