O1 (NUM-11: X1 is a thousandth, X1000. is a metre, X.5 a half)
G90 G00 X1 (expect moves: rapid X0.001)
X1000. (expect moves: rapid X1000)
X.5 (expect moves: rapid X0.5)
X0 (expect moves: rapid X0)
M30
