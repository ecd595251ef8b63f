O1 (VAR-8: X[#1] is dropped like X#1)
G90 G00 X5.
X[#1] Y2. (expect moves: rapid X5 Y2)
M30
