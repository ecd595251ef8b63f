(run with: --set #13001=5)
O1 (section 9: outside of a square, type A)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F200
Y50.
X50.
Y0
X0
G40 X-20. Y-10.
M30
(finally moves: rapid X-20 Y-10; line X-5 Y0 F200; line X-5 Y55; line X55 Y55; line X55 Y-5; line X0 Y-5; line X-20 Y-10)
