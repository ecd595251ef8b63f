(run with: --set #13001=5)
O1 (CRC-12: the same corner, type A)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100
Y50.
G40 X20. Y60.
M30
(finally moves: rapid X-20 Y-10; line X-5 Y0; line X-5 Y50; line X20 Y60)
