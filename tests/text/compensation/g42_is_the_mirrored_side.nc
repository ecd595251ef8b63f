(run with: --set #13001=5)
O1 (CRC-7, CRC-8: the square of G41 with X and Y exchanged)
G90 G00 X-10. Y-20.
G42 D1 G01 X0 Y0 F200
X50.
Y50.
X0
Y0
G40 X-10. Y-20.
M30
(finally moves: rapid X-10 Y-20; line X0 Y-5; line X55 Y-5; line X55 Y55; line X-5 Y55; line X-5 Y0; line X-10 Y-20)
