O1 (VAR-8: X[#1+0] is X0)
G90 G00 X5.
X[#1+0] (expect moves: rapid X0)
M30
