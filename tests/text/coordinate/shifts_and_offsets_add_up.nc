O1 (section 8.3: M = W + G52 + G92 + work offset + EXT)
#5201=1.
#5221=10.
G52 X100.
G90 G00 X0 (expect moves: rapid X111)
G92 X1000.
X1000. (expect moves: none)
X0 (expect moves: rapid X-889)
M30
