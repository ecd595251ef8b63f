(run with: --set #13001=5)
O1 (PS0038, CRC-11: start and centre are one point)
G90 G00 X-20.
G41 D1 G01 X0 F100
X20.
G02 X20. Y0 I0 J0
G01 X40.
G40 Y50.
M30
(finally alarm PS0038)
