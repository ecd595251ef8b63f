(run with: --param SUP/SUV=B --set #13001=5)
O1 (CRC-4: an outside obtuse corner, type B)
G90 G00 X20. Y-10.
G41 D1 G01 X0 Y0 F100
Y50.
X50.
G40 Y60.
M30
(finally moves: rapid X20 Y-10; line X-5 Y-3.0902; line X-5 Y55; line X50 Y55; line X50 Y60)
