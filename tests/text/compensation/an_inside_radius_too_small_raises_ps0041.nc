(run with: --set #13001=5)
O1 (CRC-10, CRC-14: a tool of 5 in a radius of 3)
G90 G00 X-20.
G41 D1 G01 X0 F100
X20.
G03 X23. Y3. R3. (expect alarm PS0041)
G01 Y50.
G40 Y80.
M30
