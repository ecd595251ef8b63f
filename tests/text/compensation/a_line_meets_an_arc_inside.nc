(run with: --set #13001=5)
O1 (CRC-10: the true intersection of Y5 with the circle of 25)
G90 G00 X-20.
G41 D1 G01 X0 F100
X40.
G02 X60. Y20. R20.
G01 X80.
G40 Y50.
M30
(finally moves: rapid X-20; line X0 Y5; line X35.5051 Y5; cw X60 Y25 @60,0; line X80 Y25; line X80 Y50)
