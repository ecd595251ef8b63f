(run with: --set #13001=5)
O1 (CRC-17: the path of a 90 degree turn)
G68 X0 Y0 R90.
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100
Y50.
X50.
G40 Y80.
M30
(finally moves: rapid X10 Y-20; line X0 Y-5; line X-55 Y-5; line X-55 Y50; line X-80 Y50)
