(run with: --param SUP/SUV=B --set #13001=5)
O1 (CRC-5: two extra points)
G90 G00 X5. Y20.
G41 D1 G01 X0 Y0 F100
Y50.
X50.
G40 Y60.
M30
(finally moves: rapid X5 Y20; line X3.6380 Y-6.0634; line X-5 Y-5; line X-5 Y55; line X50 Y55; line X50 Y60)
