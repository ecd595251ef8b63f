O1 (no word of these blocks is told)
G90 G02 X4. I2. J0 F100
G81 X5. Z-1. R1. K2
Q1.
G80
G04 P10
G54 P1
G30 P2 X5.
G10 L2 P1 X0
G51 I1000 J1000
G50
G68 R10.
G69
M98 P2 L2
M30
O2
M99
(finally assumed: none)
