(run with: --set #13001=5)
O1 (CRC-14: in a slot of 4 the path of the end would run backwards)
G90 G00 X-20.
G41 D1 G01 X0 F100
X20.
Y4.
X0
G40 Y50.
M30
(finally alarm PS0041)
