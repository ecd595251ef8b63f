O1 (WCS-3: G52 X10.)
G52 X10.
G90 G00 X0 (expect moves: rapid X10)
G52 X0
X0 (expect moves: rapid X0)
M30
