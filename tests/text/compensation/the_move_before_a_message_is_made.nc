(run with: --set #13001=5)
O1 (#3006 stops the machine: nothing may wait for the next move)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F200
Y50.
#3006=1(LOOK)
X50.
G40 Y60.
M30
(finally moves: rapid X-20 Y-10; line X-5 Y0 F200; line X-5 Y50; line X50 Y55; line X50 Y60)
