(run with: --param CCC=1 --set #13001=5)
O1 (CRC-9: an arc of the tool radius about the corner)
G90 G00 Y-20.
G41 D1 G01 X0 Y0 F100
Y50.
X30. Y0
G40 X60.
M30
(finally moves: rapid X0 Y-20; line X-5 Y0; line X-5 Y50; cw X4.2875 Y52.5725 @0,50; line X34.2875 Y2.5725; line X60 Y0)
