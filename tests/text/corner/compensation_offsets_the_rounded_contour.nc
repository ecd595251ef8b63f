(run with: --set #13001=1)
O1 (inside corner of radius 3, cutter radius 1: the centre path has radius 2)
G90 G00 X0 Y-5.
G41 D1 G01 X0 Y0 F100
X20. ,R3.
Y20.
G40 X10.
M30
(finally moves: rapid Y-5; line X0 Y1; line X17 Y1; ccw X19 Y3 @17,3; line X19 Y20; line X10 Y20)
