(run with: --set #13001=5)
O1 (CRC-17, G51.1: the tool stays outside)
G51.1 X0
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100
Y50.
X50.
G40 Y80.
M30
(finally moves: rapid X20 Y-10; line X5 Y0; line X5 Y55; line X-50 Y55; line X-50 Y80)
