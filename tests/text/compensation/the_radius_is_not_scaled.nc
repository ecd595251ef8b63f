(run with: --set #13001=5)
O1 (CRC-17: a contour twice as large, the same distance)
G51 X0 Y0 P2000
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100
Y25.
X25.
G40 Y40.
M30
(finally moves: rapid X-40 Y-20; line X-5 Y0; line X-5 Y55; line X50 Y55; line X50 Y80)
