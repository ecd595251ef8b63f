O1 (G51.1: x' is 2 times 10 - x)
G51.1 X10.
G90 G00 X4. Y3. (expect moves: rapid X16 Y3)
#100=#5041 (expect #100=16)
M30
