(run with: --set #13001=-5)
O1 (section 9: G41 with -5 is G42 with 5)
G90 G00 Y-20.
G41 D1 G01 X0 Y0 F100
Y50.
X50.
G40 Y60.
M30
(finally moves: rapid X0 Y-20; line X5 Y0; line X5 Y45; line X50 Y45; line X50 Y60)
