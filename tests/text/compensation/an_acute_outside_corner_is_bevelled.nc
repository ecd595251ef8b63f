(run with: --set #13001=5)
O1 (CRC-9: both lines are lengthened by the radius)
G90 G00 Y-20.
G41 D1 G01 X0 Y0 F100
Y50.
X30. Y0
G40 X60.
M30
(finally moves: rapid X0 Y-20; line X-5 Y0; line X-5 Y55; line X1.7150 Y56.8599; line X34.2875 Y2.5725; line X60 Y0)
