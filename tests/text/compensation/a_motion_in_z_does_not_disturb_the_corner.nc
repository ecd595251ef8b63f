(run with: --set #13001=5)
O1 (CRC-16: Z counts as a block without motion)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100
Y50.
Z-2.
X50.
G40 Y80.
M30
(finally moves: rapid X-20 Y-10; line X-5 Y0; line X-5 Y55 Z0; line X-5 Y55 Z-2; line X50 Y55 Z-2; line X50 Y80)
