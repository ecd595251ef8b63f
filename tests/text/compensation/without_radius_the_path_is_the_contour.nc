O1 (CRC-1: offset 1 is 0)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100
Y50.
X50.
G40 Y80.
M30
(finally moves: rapid X-20 Y-10; line X0 Y0; line X0 Y50; line X50 Y50; line X50 Y80)
