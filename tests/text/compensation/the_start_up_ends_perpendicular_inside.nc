(run with: --set #13001=5)
O1 (CRC-2: an inside corner at start-up)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100 (expect moves: line X-5 Y0)
Y50.
X50.
G40 Y80.
M30
